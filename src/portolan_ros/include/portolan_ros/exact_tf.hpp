// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

// tf2 interpolates between a stamp and itself or does not, depending on which later transforms have
// come already, and the two answers differ in their last bits. A map must not depend on that: so
// transforms enter tf without their last bits, and each is rounded again when it is asked for.

/// The transform without its last bits and with a quaternion of the right length, since tf2 would
/// scale points by what that is off.
geometry_msgs::TransformStamped without_last_bits(geometry_msgs::TransformStamped transform);

/// T_target_frame at the stamp, from transforms that entered without their last bits. Where the
/// target stands above the frame in tf's tree, as odometry's above sensors', it is the same to the
/// last bit whenever it is asked for. None where tf does not tell.
std::optional<Pose> look_up(const tf2::BufferCore& tf, const std::string& target,
                            const std::string& frame, Time stamp);

}  // namespace portolan
