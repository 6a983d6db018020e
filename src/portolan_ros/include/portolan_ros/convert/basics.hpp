// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>

#include <string>

#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan::ros_convert {

Time time(const ros::Time& stamp);
/// The nearest stamp that a message can hold: none lies before 1970 or after 2106.
ros::Time time(Time stamp);

geometry_msgs::Pose pose(const Pose& pose);
geometry_msgs::Transform transform(const Pose& pose);

/// The pose as it stands in the message; its quaternion is brought to unit length. The result is
/// not `is_valid` where the message holds NaN or a quaternion far from unit length (by over 1 %).
Pose pose(const geometry_msgs::Pose& message);
Pose pose(const geometry_msgs::Transform& message);

/// The name without the slash that old packages put before frames and topics.
std::string without_slash(const std::string& name);

/// Whether tf takes it for a frame: not empty, and without that slash.
bool is_frame_name(const std::string& name);

}  // namespace portolan::ros_convert
