// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

// Places as distance [m], azimuth and elevation [rad] about an origin, the antenna's place at the
// first range (Djugash, Singh and Grocholsky 2008): a few wide Gaussians make a whole ring.

/// The place in x, y, z [m].
Eigen::Vector3d from_polar(const Eigen::Vector3d& polar, const Eigen::Vector3d& origin);

/// d (x, y, z) / d (distance, azimuth, elevation).
Eigen::Matrix3d polar_jacobian(const Eigen::Vector3d& polar);

/// Eq. 36 for a Gaussian polar place by the unscented transform.
DistancePrediction predict_distance_polar(const Eigen::Vector3d& mean, const Eigen::Matrix3d& Q,
                                          const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& p_map);

/// Splits polar hypotheses into rows along azimuth or elevation until the distance from `p_map` is
/// nearly linear within each, to a share of the range's `stddev` [m]; not where that makes more
/// than `max_modes`. `c` is the calibration at which to look.
void split_polar(const Eigen::Vector3d& p_map, double stddev, const Eigen::Vector3d& origin,
                 const RangeCalibration& c, std::size_t max_modes,
                 std::vector<Hypothesis>& hypotheses);

/// Makes x, y, z of those polar hypotheses that are narrow enough for a straight Gaussian: bent by
/// less than a fraction of their thickness.
void straighten_polar(const Eigen::Vector3d& origin, const RangeCalibration& c,
                      std::vector<Hypothesis>& hypotheses);

/// The hypothesis as x, y, z, in as many straight Gaussians as it takes; appended to `straight`.
void append_straightened(const Hypothesis& polar, const Eigen::Vector3d& origin,
                         const RangeCalibration& c, std::vector<Hypothesis>& straight);

}  // namespace portolan
