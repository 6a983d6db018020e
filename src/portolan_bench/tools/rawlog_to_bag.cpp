// SPDX-License-Identifier: BSD-3-Clause
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mrpt_rawlog.hpp"

namespace portolan::bench {
namespace {

constexpr double kBeyondEnds = 0.2;    // tf reaches so far beyond the first and last scan [s]
constexpr double kStaticPeriod = 5.0;  // of repeating the mounts [s]

geometry_msgs::Quaternion quaternion(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

tf2_msgs::TFMessage transform(const std::string& parent, const std::string& child, double stamp,
                              const Pose& pose) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms.front();
  transform.header.stamp = ros::Time(stamp);
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.translation().x();
  transform.transform.translation.y = pose.translation().y();
  transform.transform.translation.z = pose.translation().z();
  transform.transform.rotation = quaternion(pose);
  return message;
}

sensor_msgs::LaserScan laser_scan(const RawlogScan& seen) {
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(seen.stamp);
  message.header.frame_id = "laser";
  message.angle_min = static_cast<float>(seen.scan.angle_min);
  message.angle_increment = static_cast<float>(seen.scan.angle_increment);
  message.angle_max =
      static_cast<float>(seen.scan.angle_min + static_cast<double>(seen.scan.ranges.size() - 1) *
                                                   seen.scan.angle_increment);
  message.range_min = static_cast<float>(seen.scan.range_min);
  message.range_max = static_cast<float>(seen.scan.range_max);
  message.ranges = seen.scan.ranges;
  return message;
}

nav_msgs::Odometry odometry(const RawlogScan& seen, const RawlogScan* before) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(seen.stamp);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose.position.x = seen.T_odom_base.translation().x();
  message.pose.pose.position.y = seen.T_odom_base.translation().y();
  message.pose.pose.orientation = quaternion(seen.T_odom_base);
  if (before == nullptr || seen.stamp <= before->stamp) return message;
  const Pose moved = before->T_odom_base.inverse() * seen.T_odom_base;
  const double duration = seen.stamp - before->stamp;
  message.twist.twist.linear.x = moved.translation().x() / duration;
  message.twist.twist.linear.y = moved.translation().y() / duration;
  message.twist.twist.angular.z = yaw(moved) / duration;
  return message;
}

/// A bag by the conventions of ROS: odom -> base_link on /tf, the mount latched on /tf_static.
class Writer {
 public:
  explicit Writer(const std::string& path) : bag_(path, rosbag::bagmode::Write) {}

  void write(const std::vector<RawlogScan>& scans) {
    const RawlogScan* before = nullptr;
    write_base(scans.front(), scans.front().stamp - kBeyondEnds);
    for (const RawlogScan& seen : scans) {
      if (before == nullptr || seen.stamp >= next_static_) write_mount(seen);
      write_base(seen, seen.stamp);
      bag_.write("/odom", ros::Time(seen.stamp), odometry(seen, before));
      bag_.write("/scan", ros::Time(seen.stamp), laser_scan(seen));
      before = &seen;
    }
    write_base(scans.back(), scans.back().stamp + kBeyondEnds);
  }

 private:
  void write_base(const RawlogScan& seen, double stamp) {
    bag_.write("/tf", ros::Time(stamp), transform("odom", "base_link", stamp, seen.T_odom_base));
  }

  void write_mount(const RawlogScan& seen) {
    using Message = tf2_msgs::TFMessage;
    const auto header = boost::make_shared<ros::M_string>();
    (*header)["topic"] = "/tf_static";
    (*header)["type"] = ros::message_traits::DataType<Message>::value();
    (*header)["md5sum"] = ros::message_traits::MD5Sum<Message>::value();
    (*header)["message_definition"] = ros::message_traits::Definition<Message>::value();
    (*header)["latching"] = "1";
    bag_.write("/tf_static", ros::Time(seen.stamp - (next_static_ == 0.0 ? kBeyondEnds : 0.0)),
               transform("base_link", "laser", seen.stamp, seen.T_base_sensor), header);
    next_static_ = seen.stamp + kStaticPeriod;
  }

  rosbag::Bag bag_;
  double next_static_ = 0.0;
};

}  // namespace
}  // namespace portolan::bench

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: rawlog_to_bag RAWLOG BAG\n";
    return 2;
  }
  const auto scans = portolan::bench::read_rawlog(argv[1]);
  if (scans.empty()) throw std::runtime_error(std::string(argv[1]) + ": holds no laser scans");
  portolan::bench::Writer(argv[2]).write(scans);
  std::cout << scans.size() << " scans written to " << argv[2] << "\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
