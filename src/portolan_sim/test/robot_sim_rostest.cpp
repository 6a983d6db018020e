// SPDX-License-Identifier: BSD-3-Clause
// The node as others see it: a whole short drive, then another one after a reset.
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <portolan_msgs/BeaconRanges.h>
#include <portolan_msgs/ImageFeatures.h>
#include <portolan_msgs/LandmarkSightings.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace {

/// Keeps every message of a topic.
template <class Message>
class Heard {
 public:
  Heard(ros::NodeHandle& handle, const std::string& topic)
      : subscriber_(handle.subscribe<Message>(topic, 0, &Heard::keep, this)) {}

  std::vector<Message> messages;

 private:
  void keep(const typename Message::ConstPtr& message) { messages.push_back(*message); }

  ros::Subscriber subscriber_;
};

bool eventually(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30.0);
  while (ros::ok() && ros::WallTime::now() < end) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    if (condition()) return true;
  }
  return false;
}

class RobotSim : public ::testing::Test {
 protected:
  bool drove_to_the_end() {
    return eventually(
        [this] { return !finished.messages.empty() && finished.messages.back().data; });
  }

  /// The scans of the first moment of each run.
  std::vector<std::vector<float>> first_scans() {
    std::vector<std::vector<float>> first;
    for (const sensor_msgs::LaserScan& scan : scans.messages) {
      if (scan.header.stamp == ros::Time(10.0)) first.push_back(scan.ranges);
    }
    return first;
  }

  bool clock_ran_back() {
    const auto& ticks = clock.messages;
    const auto back = [](const auto& before, const auto& after) {
      return after.clock < before.clock;
    };
    return std::adjacent_find(ticks.begin(), ticks.end(), back) != ticks.end();
  }

  ros::NodeHandle handle;
  Heard<tf2_msgs::TFMessage> tf{handle, "/tf"};
  Heard<tf2_msgs::TFMessage> tf_static{handle, "/tf_static"};
  Heard<nav_msgs::Odometry> odometry{handle, "odom"};
  Heard<nav_msgs::Odometry> truth{handle, "ground_truth"};
  Heard<sensor_msgs::LaserScan> scans{handle, "scan"};
  Heard<sensor_msgs::Range> echoes{handle, "sonar"};
  Heard<sensor_msgs::PointCloud2> clouds{handle, "cloud_in"};
  Heard<portolan_msgs::LandmarkSightings> sightings{handle, "landmark_sightings"};
  Heard<portolan_msgs::ImageFeatures> features{handle, "image_features"};
  Heard<sensor_msgs::CameraInfo> camera_info{handle, "camera_info"};
  Heard<portolan_msgs::BeaconRanges> ranges{handle, "beacon_ranges"};
  Heard<rosgraph_msgs::Clock> clock{handle, "/clock"};
  Heard<std_msgs::Bool> finished{handle, "path_finished"};
};

TEST_F(RobotSim, DrivesMeasuresAndDrivesAgainAfterAReset) {
  ASSERT_TRUE(drove_to_the_end());
  ASSERT_TRUE(eventually([this] {
    return !clock.messages.empty() && !truth.messages.empty() && !camera_info.messages.empty() &&
           !ranges.messages.empty() && !tf_static.messages.empty() &&
           truth.messages.back().pose.pose.position.x > 3.9;
  }));

  // Every frame is the robot's own, and the mount of every sensor is known.
  std::set<std::string> frames;
  for (const auto& transform : tf_static.messages.back().transforms) {
    EXPECT_EQ(transform.header.frame_id, "ship/base_link");
    frames.insert(transform.child_frame_id);
  }
  EXPECT_EQ(frames.size(), 1U + 8U + 1U + 3U);
  EXPECT_EQ(frames.count(scans.messages.front().header.frame_id), 1U);
  EXPECT_EQ(frames.count(echoes.messages.front().header.frame_id), 1U);
  EXPECT_EQ(frames.count(clouds.messages.front().header.frame_id), 1U);
  EXPECT_EQ(tf.messages.front().transforms.at(0).header.frame_id, "ship/odom");
  EXPECT_EQ(odometry.messages.front().child_frame_id, "ship/base_link");

  // Nothing was lost: time began only when all of us were listening.
  EXPECT_EQ(scans.messages.front().header.stamp, ros::Time(10.0));
  for (std::size_t i = 1; i < scans.messages.size(); ++i) {
    const ros::Duration gap = scans.messages[i].header.stamp - scans.messages[i - 1].header.stamp;
    EXPECT_NEAR(gap.toSec(), 0.1, 1e-6);
  }
  EXPECT_NEAR(truth.messages.back().pose.pose.position.x, 4.0, 0.1);
  EXPECT_EQ(clouds.messages.front().data.size(), 4U * 36U * 12U);
  EXPECT_EQ(sightings.messages.front().sightings.at(0).id, 3);
  EXPECT_NEAR(sightings.messages.front().sightings.at(0).range, 4.8, 0.3);
  EXPECT_EQ(features.messages.front().features.at(0).id, 3);
  EXPECT_EQ(camera_info.messages.front().K[0], 500.0);
  EXPECT_EQ(ranges.messages.front().ranges.at(0).id, 4U);

  // After a reset the clock runs back, and the same things happen again.
  finished.messages.clear();
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("robot_sim/reset", reset));
  EXPECT_TRUE(reset.response.success);
  ASSERT_TRUE(drove_to_the_end());
  ASSERT_TRUE(eventually([this] { return first_scans().size() == 2; }));
  EXPECT_EQ(first_scans()[0], first_scans()[1]);
  ASSERT_TRUE(eventually([this] { return clock_ran_back(); }));

  std_srvs::Trigger saved;
  ASSERT_TRUE(ros::service::call("robot_sim/truth", saved));
  EXPECT_FALSE(saved.response.success);
  EXPECT_NE(saved.response.message.find("truth_directory"), std::string::npos);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "robot_sim_rostest");
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
