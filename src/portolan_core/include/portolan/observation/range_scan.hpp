// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/pose.hpp"

namespace portolan {

/// One sweep of a planar laser: ranges at equal steps of angle in the sensor's xy plane.
struct RangeScan {
  double angle_min = 0.0;        ///< of the first beam, counter-clockwise from +x [rad]
  double angle_increment = 0.0;  ///< from beam to beam; negative where it turns clockwise [rad]
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]
  std::vector<float> ranges;     ///< [m]; see `range_reading` for what odd values mean

  /// The sensor's pose at the last beam, seen from its pose at the first one: the motion during a
  /// slow sweep. Identity where the sweep is fast or the motion unknown.
  Pose T_first_last = Pose::Identity();
};

/// True where angles and limits are finite, the increment is not 0, the limits make sense, and
/// neither the first angle nor the whole sweep is over ten turns.
bool is_usable(const RangeScan& scan);

/// What it occupies in memory [byte].
inline std::size_t byte_size(const RangeScan& scan) {
  return sizeof(scan) + scan.ranges.capacity() * sizeof(float);
}

}  // namespace portolan
