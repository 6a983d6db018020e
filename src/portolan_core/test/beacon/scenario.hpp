// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/testing/dice.hpp"

namespace portolan::beacon_test {

using testing::Dice;

inline BeaconRanges one_range(BeaconId id, double range, double stddev) {
  BeaconRanges z;
  z.ranges.push_back({id, range, stddev});
  return z;
}

inline Pose antenna_at(double x, double y, double z = 0.0) {
  Pose pose = planar_pose(x, y, 0.3);
  pose.translation().z() = z;
  return pose;
}

/// Straight ahead along x, then a turn to the left: the path of Figure 11.
inline Pose figure_11(int step, int straight_steps) {
  if (step < straight_steps) return antenna_at(0.5 * step, 0.0);
  const double turn = 0.15 * (step - straight_steps + 1);
  return antenna_at(0.5 * (straight_steps - 1) + 3.0 * std::sin(turn),
                    3.0 * (1.0 - std::cos(turn)));
}

/// Options for ranges that read what they are, from poses that are known.
inline BeaconOptions calibrated() {
  BeaconOptions options;
  options.drift = 0.0;
  options.learn_noise = false;
  options.calibration.scale_stddev = 0.0;
  options.calibration.bias_stddev = 0.0;
  options.calibration.turn_stddev = 0.0;
  return options;
}

}  // namespace portolan::beacon_test
