// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

/// Makes one of hypotheses that stand closer than `distance` in the Mahalanobis sense, keeping
/// weight, mean and covariance of the pair; further apart too where the distance from the antenna
/// of `z` stays all but linear over both. Neighbours in the list are compared each time, all
/// pairs every few turns and only where they are few, so that a crowded ring costs linear time.
void merge_close(double distance, std::size_t turn, const PosedRange& z,
                 std::vector<Hypothesis>& hypotheses);

/// The Mahalanobis distance of two places, their errors taken as independent.
double mahalanobis_distance(const Hypothesis& a, const Hypothesis& b,
                            const RangeCalibration& calibration);

}  // namespace portolan
