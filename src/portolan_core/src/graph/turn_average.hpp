// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graph/block_pattern.hpp"
#include "graph/problem.hpp"

namespace portolan {

/// Turns poses until the turns along arcs agree as well as they do anywhere near: Gauss-Newton on
/// orientations alone, each arc weighted by one number. Positions stay. In the plane that keeps how
/// often headings turn round each loop. False where arcs leave an orientation open.
template <class Motion>
bool average_turns(const Problem<Motion>& problem, const BlockPattern& pattern,
                   std::vector<typename Motion::State>& states);

}  // namespace portolan
