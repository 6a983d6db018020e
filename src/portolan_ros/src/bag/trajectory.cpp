// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/trajectory.hpp"

#include <cstdint>
#include <cstdio>
#include <utility>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

std::string tum_line(Time stamp, const Pose& pose) {
  const auto ns = static_cast<std::int64_t>(stamp.time_since_epoch().count());
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d p = pose.translation();
  char line[256];
  std::snprintf(line, sizeof(line), "%lld.%09lld %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n",
                static_cast<long long>(ns / 1000000000), static_cast<long long>(ns % 1000000000),
                p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  return line;
}

}  // namespace

Trajectory::Trajectory(const std::string& odom_frame, const std::string& base_frame)
    : odom_frame_(ros_convert::without_slash(odom_frame)),
      base_frame_(ros_convert::without_slash(base_frame)) {}

void Trajectory::receive_tf(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    keep(transform.header, transform.child_frame_id, ros_convert::pose(transform.transform));
  }
}

void Trajectory::receive_odometry(const nav_msgs::Odometry& message) {
  std_msgs::Header header = message.header;
  if (header.frame_id.empty()) header.frame_id = odom_frame_;
  const bool unnamed = message.child_frame_id.empty();
  keep(header, unnamed ? base_frame_ : message.child_frame_id,
       ros_convert::pose(message.pose.pose));
}

void Trajectory::keep(const std_msgs::Header& header, const std::string& child,
                      const Pose& T_odom_base) {
  const bool ours = ros_convert::without_slash(header.frame_id) == odom_frame_ &&
                    ros_convert::without_slash(child) == base_frame_;
  const Time stamp = ros_convert::time(header.stamp);
  if (ours && stamp != Time{} && is_valid(T_odom_base)) {
    T_odom_base_.try_emplace(stamp, T_odom_base);
  }
}

std::vector<Pose> Trajectory::in_map(const Correction& correction) const {
  std::vector<Pose> poses;
  poses.reserve(T_odom_base_.size());
  for (const auto& [stamp, T_odom_base] : T_odom_base_) {
    poses.push_back(correction.at(stamp) * T_odom_base);
  }
  return poses;
}

std::string Trajectory::tum(const Correction& correction) const {
  std::string text;
  for (const auto& [stamp, T_odom_base] : T_odom_base_) {
    text += tum_line(stamp, correction.at(stamp) * T_odom_base);
  }
  return text;
}

}  // namespace portolan
