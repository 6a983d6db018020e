// SPDX-License-Identifier: BSD-3-Clause
#include "robot_messages.hpp"

#include "portolan_ros/convert/basics.hpp"

namespace portolan::sim {

namespace {

/// As tf has it.
geometry_msgs::TransformStamped transform_of(const std_msgs::Header& header,
                                             const std::string& child, const Pose& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.child_frame_id = child;
  transform.transform = ros_convert::transform(pose);
  return transform;
}

}  // namespace

RobotMessages::RobotMessages(const RobotSimOptions& options, const std::vector<AnySensor>& sensors)
    : options_(options) {
  for (const AnySensor& sensor : sensors) {
    const auto* camera = std::get_if<Camera>(&sensor);
    if (camera != nullptr) cameras_[camera->options().frame] = camera->options();
  }
}

tf2_msgs::TFMessage RobotMessages::mounts_at(Time now,
                                             const std::vector<AnySensor>& sensors) const {
  std_msgs::Header header;
  header.stamp = ros_convert::time(now);
  header.frame_id = options_.frame_prefix + options_.base_frame;
  tf2_msgs::TFMessage tf;
  for (const AnySensor& sensor : sensors) {
    for (const Mount& mount : mounts(sensor)) {
      tf.transforms.push_back(
          transform_of(header, options_.frame_prefix + mount.frame, mount.T_base_frame));
    }
  }
  return tf;
}

std::string RobotMessages::info_topic(const std::string& features) {
  return features.substr(0, features.rfind('/') + 1) + "camera_info";
}

std_msgs::Header RobotMessages::header_of(const Event& event) const {
  std_msgs::Header header;
  header.stamp = ros_convert::time(event.stamp);
  header.frame_id = options_.frame_prefix + event.frame;
  return header;
}

nav_msgs::Odometry RobotMessages::odometry(std_msgs::Header header,
                                           const Event::Odometry& z) const {
  header.frame_id = options_.frame_prefix + options_.odom_frame;
  nav_msgs::Odometry odometry = message(header, z);
  odometry.child_frame_id = options_.frame_prefix + options_.base_frame;
  return odometry;
}

nav_msgs::Odometry RobotMessages::truth(std_msgs::Header header, const Event::Truth& z) const {
  header.frame_id = options_.map_frame;
  nav_msgs::Odometry truth = message(header, z);
  truth.child_frame_id = options_.frame_prefix + options_.base_frame;
  return truth;
}

tf2_msgs::TFMessage RobotMessages::transform(const nav_msgs::Odometry& odometry,
                                             const Pose& T_odom_base) {
  tf2_msgs::TFMessage tf;
  tf.transforms = {transform_of(odometry.header, odometry.child_frame_id, T_odom_base)};
  return tf;
}

}  // namespace portolan::sim
