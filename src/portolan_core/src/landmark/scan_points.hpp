// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "portolan/landmark/scan_detectors.hpp"

namespace portolan {

/// Where one beam met something.
struct ScanPoint {
  std::size_t beam;
  double range;       ///< from the sensor at that moment [m]
  Eigen::Vector2d p;  ///< in the sensor's plane where the scan began [m]
};

/// The echoes up to `max_range` in the order of beams, in the frame of the sensor at the first.
std::vector<ScanPoint> scan_points(const RangeScan& scan, double max_range);

/// Runs of points of which neighbours are at most `gap` [m] and two beams apart.
std::vector<std::vector<ScanPoint>> clustered(const std::vector<ScanPoint>& points, double gap);

/// The sighting of a point in the sensor's plane with this covariance [m^2].
LandmarkSighting planar_sighting(const Eigen::Vector2d& p, const Eigen::Matrix2d& covariance);

}  // namespace portolan
