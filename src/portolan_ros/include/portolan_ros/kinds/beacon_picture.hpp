// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "portolan/beacon/beacon_estimate.hpp"
#include "portolan/pose.hpp"
#include "portolan_ros/picture.hpp"

namespace portolan {

/// What a picture of beacons shows.
struct BeaconScene {
  std::vector<BeaconEstimate> beacons;
  std::vector<Eigen::Vector3d> way;           ///< of the robot, in the map [m]
  std::vector<Eigen::Vector3d> truth;         ///< where beacons really are, if that is known [m]
  std::optional<Eigen::AlignedBox2d> extent;  ///< what to show [m]; none: all that there is
};

/// The scene from above: each mode as an ellipse of two standard deviations, the heavier the
/// stronger its colour, orange while the beacon is ambiguous, then green, with its id where there
/// is room; the way in blue, the drive that would tell most as a red line, the truth as black
/// crosses. The longer side has `side` pixels.
Picture beacon_picture(const BeaconScene& scene, std::size_t side);

}  // namespace portolan
