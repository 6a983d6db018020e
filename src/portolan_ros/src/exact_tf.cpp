// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/exact_tf.hpp"

#include <tf2/exceptions.h>

#include <cmath>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

geometry_msgs::Transform rounded(geometry_msgs::Transform transform) {
  constexpr double kLength = 4294967296.0;       // steps in a metre
  constexpr double kRotation = 1099511627776.0;  // steps of a quaternion's parts
  const auto round = [](double& value, double steps) { value = std::round(value * steps) / steps; };
  for (double* length :
       {&transform.translation.x, &transform.translation.y, &transform.translation.z}) {
    round(*length, kLength);
  }
  for (double* part : {&transform.rotation.x, &transform.rotation.y, &transform.rotation.z,
                       &transform.rotation.w}) {
    round(*part, kRotation);
  }
  return transform;
}

Pose edge(const tf2::BufferCore& tf, const std::string& parent, const std::string& child,
          const ros::Time& time) {
  return ros_convert::pose(rounded(tf.lookupTransform(parent, child, time).transform));
}

}  // namespace

geometry_msgs::TransformStamped without_last_bits(geometry_msgs::TransformStamped transform) {
  geometry_msgs::Quaternion& q = transform.transform.rotation;
  const double norm = Eigen::Quaterniond(q.w, q.x, q.y, q.z).norm();
  q.w /= norm;
  q.x /= norm;
  q.y /= norm;
  q.z /= norm;
  transform.transform = rounded(transform.transform);
  return transform;
}

std::optional<Pose> look_up(const tf2::BufferCore& tf, const std::string& target,
                            const std::string& frame, Time stamp) {
  const ros::Time time = ros_convert::time(stamp);
  // Asking first is far cheaper than an exception for each message that waits, at each transform.
  if (!ros_convert::is_frame_name(frame) || !tf.canTransform(target, frame, time))
    return std::nullopt;
  try {
    Pose T_child_frame = Pose::Identity();
    std::string child = frame;
    // Edge by edge up to the target: a product of several would be rounded from other bits.
    for (std::string parent; child != target; child = parent) {
      if (!tf._getParent(child, time, parent)) return edge(tf, target, frame, time);
      T_child_frame = edge(tf, parent, child, time) * T_child_frame;
    }
    return T_child_frame;
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace portolan
