// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {

/// The map as YAML: `version`, `drift`, `noise`, `calibration`, and `beacons` with `id, ranges,
/// outliers, restarts` and `modes` of `weight, mean: [x, y, z], covariance: [9, row-major]`,
/// heaviest first [m].
std::string to_yaml(const BeaconMapper& mapper);

/// The mapper that goes on from what `to_yaml` wrote; written again it gives the same text. What
/// ranges said of place and calibration together is not in the file: both go on independently.
/// Throws std::runtime_error that says what is wrong: version, sizes, numbers that are not
/// finite, weights that do not sum to 1, covariances that are none, an id twice. Without
/// `outliers`, `restarts`, `drift`, `noise` or `calibration`, 0 and the options' values stand in.
BeaconMapper beacons_from_yaml(const std::string& text, const BeaconOptions& options);

}  // namespace portolan
