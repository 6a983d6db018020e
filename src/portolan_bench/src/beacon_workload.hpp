// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan::bench {

/// Ranges to beacons from known poses.
struct BeaconWorkload {
  struct PosedRanges {
    BeaconRanges z;
    Pose T_map_sensor;
  };

  std::string name;
  double stddev = 0.1;  // that the peer is told [m]
  std::vector<PosedRanges> posed;
  std::map<BeaconId, Eigen::Vector3d> truth;  // [m]; may be empty

  std::size_t ranges() const;
};

/// Eight beacons in 16 m by 16 m, ranges with `stddev` [m] of noise: a robot that drives straight,
/// so that each beacon keeps its mirror image, and one that drives a loop.
BeaconWorkload straight_drive(double stddev);
BeaconWorkload loop_drive(double stddev);

}  // namespace portolan::bench
