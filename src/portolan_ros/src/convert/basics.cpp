// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/basics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace portolan::ros_convert {

namespace {

template <class Vector, class Quaternion>
Pose pose_from(const Vector& p, const Quaternion& q) {
  Pose pose = Pose::Identity();
  Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  const bool is_unit = std::abs(rotation.norm() - 1.0) < 0.01;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  pose.linear() =
      is_unit ? rotation.normalized().toRotationMatrix() : Eigen::Matrix3d::Constant(nan).eval();
  pose.translation() = Eigen::Vector3d(p.x, p.y, p.z);
  return pose;
}

template <class Quaternion>
void set_rotation(Quaternion& message, const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
}

template <class Vector>
void set_translation(Vector& message, const Pose& pose) {
  message.x = pose.translation().x();
  message.y = pose.translation().y();
  message.z = pose.translation().z();
}

}  // namespace

Time time(const ros::Time& stamp) {
  return Time(Duration(static_cast<Duration::rep>(stamp.toNSec())));
}

ros::Time time(Time stamp) {
  const Time most = time(ros::TIME_MAX);
  ros::Time message;
  message.fromNSec(
      static_cast<std::uint64_t>(std::clamp(stamp, Time{}, most).time_since_epoch().count()));
  return message;
}

geometry_msgs::Pose pose(const Pose& pose) {
  geometry_msgs::Pose message;
  set_translation(message.position, pose);
  set_rotation(message.orientation, pose);
  return message;
}

geometry_msgs::Transform transform(const Pose& pose) {
  geometry_msgs::Transform message;
  set_translation(message.translation, pose);
  set_rotation(message.rotation, pose);
  return message;
}

Pose pose(const geometry_msgs::Pose& message) {
  return pose_from(message.position, message.orientation);
}

Pose pose(const geometry_msgs::Transform& message) {
  return pose_from(message.translation, message.rotation);
}

std::string without_slash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

bool is_frame_name(const std::string& name) { return !name.empty() && name.front() != '/'; }

}  // namespace portolan::ros_convert
