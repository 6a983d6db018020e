// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"

namespace portolan::bench {

/// A robot's laser log: each scan with the odometry at its time.
struct RawlogScan {
  double stamp = 0.0;  ///< since the Unix epoch [s]
  Pose T_odom_base = Pose::Identity();
  Pose T_base_sensor = Pose::Identity();
  RangeScan scan;
};

/// Reads a rawlog of actions and sensory frames. Throws std::runtime_error with the path.
std::vector<RawlogScan> read_rawlog(const std::string& path);

}  // namespace portolan::bench
