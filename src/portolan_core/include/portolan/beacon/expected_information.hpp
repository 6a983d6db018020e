// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "portolan/beacon/beacon_estimate.hpp"
#include "portolan/beacon/beacon_options.hpp"

namespace portolan {

/// How much one range taken at `p_map` [m] is expected to tell of a beacon: the mutual information
/// of range and place [nat], from an upper bound of the entropy of a sum of Gaussians.
double expected_information(const std::vector<BeaconMode>& modes, const Eigen::Vector3d& p_map,
                            double stddev);

/// The short drive from `p_map` [m] to the place where a range is expected to tell most; it tells
/// two modes apart or shrinks the one that is left. None where even that would be less than a tenth
/// of a nat. `stddev` [m] is how wide ranges spread, as stated or as learnt.
std::optional<BeaconDrive> best_drive(const std::vector<BeaconMode>& modes,
                                      const Eigen::Vector3d& p_map, double stddev,
                                      BeaconSpace space);

}  // namespace portolan
