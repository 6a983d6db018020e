// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graph/block_pattern.hpp"
#include "graph/problem.hpp"

namespace portolan {

/// Orientations by linear least squares as if rotation matrices could be any, each then made the
/// rotation next to it. Those of poses that are not fixed may be anywhere before. False where arcs
/// leave one undetermined.
bool orient_by_matrices(const Problem<SpatialMotion>& problem, const BlockPattern& pattern,
                        std::vector<SpatialMotion::State>& states);

}  // namespace portolan
