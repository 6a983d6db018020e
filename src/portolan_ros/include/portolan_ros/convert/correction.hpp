// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/DriftCorrection.h>

#include <string>

#include "portolan/correction.hpp"

namespace portolan::ros_convert {

/// What the message says about `odom_frame` in `map_frame`. Throws std::invalid_argument where it
/// is about other frames (naming no map frame, it is taken for this one), stamps and poses differ
/// in number, stamps do not increase, or a pose is not a finite rigid motion.
Correction correction(const portolan_msgs::DriftCorrection& message, const std::string& map_frame,
                      const std::string& odom_frame);

/// The snapshot as a message about `odom_frame` in `map_frame`, without a stamp.
portolan_msgs::DriftCorrection correction(const Correction& correction,
                                          const std::string& map_frame,
                                          const std::string& odom_frame);

}  // namespace portolan::ros_convert
