// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace portolan {

/// The identity that a beacon transmits.
using BeaconId = std::uint32_t;

/// One place where a beacon may be.
struct BeaconMode {
  double weight = 0.0;                                   ///< in (0, 1]; they sum to 1
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();        ///< in the map [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< uncertain calibration included [m^2]
};

/// Where to drive so that the next range to a beacon tells most of its place.
struct BeaconDrive {
  Eigen::Vector3d p_map = Eigen::Vector3d::Zero();      ///< of the antenna now [m]
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit vector in the map
  double distance = 0.0;                                ///< how far [m]
  double information = 0.0;  ///< that a range taken there is expected to give [nat]
};

/// All that is known of one beacon, and what is not.
struct BeaconEstimate {
  BeaconId id = 0;
  std::size_t ranges = 0;         ///< taken
  std::size_t outliers = 0;       ///< those of them that no mode could explain
  std::size_t restarts = 0;       ///< how often it was started anew
  bool ambiguous = true;          ///< other modes than the first hold more than the given share
  std::vector<BeaconMode> modes;  ///< heaviest first

  /// None where the next ranges would tell next to nothing, or where no range came yet since the
  /// map was loaded.
  std::optional<BeaconDrive> drive;
};

/// Ranges that a mapper took and that it could not take.
struct BeaconCounts {
  std::size_t taken = 0;
  std::size_t malformed = 0;  ///< not finite, zero, negative
  std::size_t too_long = 0;   ///< beyond the device's reach
  std::size_t refused = 0;    ///< of a beacon too many
};

}  // namespace portolan
