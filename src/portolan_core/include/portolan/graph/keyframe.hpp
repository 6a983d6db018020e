// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// A moment of the trajectory that the pose graph remembers, with what the robot saw.
struct Keyframe {
  Time stamp{};
  Pose T_odom_base = Pose::Identity();
  Pose T_base_sensor = Pose::Identity();
  RangeScan scan;          ///< empty where it was given up to save memory
  double travelled = 0.0;  ///< way from the first keyframe, by odometry [m]
};

}  // namespace portolan
