// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/beacon/beacon_options.hpp"
#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

/// The inverse sensor model, Eq. 37, as a sum of Gaussians, Eq. 38: replaces `modes` by a ring
/// (planar) or a shell between two elevations (spatial) about the antenna. Weights sum to 1.
///
/// With up to `max_modes` the density of a planar ring differs from Eq. 37's by less than 3 % in
/// total variation where the range exceeds ten standard deviations; fewer make a lumpier ring. A
/// range shorter than two standard deviations gives one blob.
void inverse_range(const PosedRange& z, const RangeCalibration& calibration,
                   const BeaconOptions& options, std::vector<Hypothesis>& modes);

/// The same in distance and direction about the antenna: a few wide Gaussians (Figure 12).
void inverse_range_polar(const PosedRange& z, const RangeCalibration& calibration,
                         const BeaconOptions& options, std::vector<Hypothesis>& modes);

}  // namespace portolan
