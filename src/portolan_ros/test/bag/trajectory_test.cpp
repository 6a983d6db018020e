// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "posed_input_fixture.hpp"

namespace portolan {
namespace {

class TrajectoryTest : public testing::Test {
 protected:
  void receive(const std::string& parent, const std::string& child, double s, const Pose& pose) {
    trajectory.receive_tf(tf_message(transform(parent, child, s, pose)));
  }

  Trajectory trajectory{"odom", "/base_link"};
};

TEST_F(TrajectoryTest, IsEmptyAtFirst) {
  EXPECT_TRUE(trajectory.empty());
  EXPECT_EQ(trajectory.tum({}), "");
  EXPECT_TRUE(trajectory.in_map({}).empty());
}

TEST_F(TrajectoryTest, WritesALineForEachStampInTheirOrder) {
  receive("odom", "base_link", 2.5, planar_pose(1.0, -2.0, 0.0));
  receive("/odom", "/base_link", 1.000000001,
          Eigen::Translation3d(0.0, 0.0, 0.125) * planar_pose(0.5, 0.0, M_PI));
  EXPECT_FALSE(trajectory.empty());
  EXPECT_EQ(trajectory.tum({}),
            "1.000000001 0.500000000 0.000000000 0.125000000 "
            "0.000000000 0.000000000 1.000000000 0.000000000\n"
            "2.500000000 1.000000000 -2.000000000 0.000000000 "
            "0.000000000 0.000000000 0.000000000 1.000000000\n");
}

TEST_F(TrajectoryTest, IsCorrectedForEachStamp) {
  receive("odom", "base_link", 1.0, planar_pose(1.0, 0.0, 0.0));
  receive("odom", "base_link", 2.0, planar_pose(2.0, 0.0, 0.0));
  const Correction correction({{at(1.0), Pose::Identity()}, {at(3.0), planar_pose(0.0, 4.0, 0.0)}});
  const std::vector<Pose> poses = trajectory.in_map(correction);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_TRUE(poses[0].isApprox(planar_pose(1.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(poses[1].isApprox(planar_pose(2.0, 2.0, 0.0), 1e-12));
  EXPECT_EQ(trajectory.tum(correction).find("2.000000000 2.000000000 2.000000000"),
            trajectory.tum(correction).find('\n') + 1);
}

TEST_F(TrajectoryTest, TakesOdometryWhoseFramesMayBeMissing) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(4, 0);
  message.pose.pose = ros_convert::pose(planar_pose(3.0, 0.0, 0.0));
  trajectory.receive_odometry(message);
  message.header.stamp = ros::Time(5, 0);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  trajectory.receive_odometry(message);
  message.header.stamp = ros::Time(6, 0);
  message.child_frame_id = "wheel";
  trajectory.receive_odometry(message);
  EXPECT_EQ(trajectory.in_map({}).size(), 2u);
}

TEST_F(TrajectoryTest, TheFirstWordOnAStampCounts) {
  receive("odom", "base_link", 1.0, planar_pose(1.0, 0.0, 0.0));
  receive("odom", "base_link", 1.0, planar_pose(2.0, 0.0, 0.0));
  ASSERT_EQ(trajectory.in_map({}).size(), 1u);
  EXPECT_EQ(trajectory.in_map({})[0].translation().x(), 1.0);
}

TEST_F(TrajectoryTest, LeavesOutWhatIsNotTheRobotsOdometry) {
  receive("map", "odom", 1.0, Pose::Identity());
  receive("base_link", "laser", 1.0, Pose::Identity());
  receive("odom", "base_link", 0.0, Pose::Identity());
  Pose nowhere = Pose::Identity();
  nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
  receive("odom", "base_link", 1.0, nowhere);
  EXPECT_TRUE(trajectory.empty());
}

}  // namespace
}  // namespace portolan
