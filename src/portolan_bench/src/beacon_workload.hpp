// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan::bench {

using Places = std::map<BeaconId, Eigen::Vector3d>;  ///< [m]

/// Ranges to beacons from known poses.
struct BeaconWorkload {
  struct PosedRanges {
    BeaconRanges z;
    Pose T_map_sensor;
  };

  std::string name;
  double stddev = 0.1;  // that the peer is told [m]
  std::vector<PosedRanges> posed;
  Places truth;  // may be empty

  std::size_t ranges() const;
};

/// Eight beacons in 16 m by 16 m, ranges with `stddev` [m] of noise: a robot that drives straight,
/// so that each beacon keeps its mirror image, and one that drives a loop.
BeaconWorkload straight_drive(double stddev);
BeaconWorkload loop_drive(double stddev);

/// A mapper of ours that was given all of it, and where it takes each beacon to be most likely.
BeaconMapper map_beacons(const BeaconOptions& options, const BeaconWorkload& load);
Places places(const BeaconMapper& mapper);

/// Lines `id x y`; what follows in a line is ignored. Throws std::runtime_error with the path.
Places read_places(const std::string& path);

}  // namespace portolan::bench
