// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graph/block_pattern.hpp"
#include "graph/problem.hpp"

namespace portolan {

/// First coordinates by two linear least squares: orientations as if rotation matrices could be
/// any, each then made the rotation next to it; and with these the positions. Poses that are not
/// fixed may be anywhere before. None where arcs leave a pose undetermined.
template <class Motion>
std::optional<std::vector<typename Motion::State>> rotation_start(
    const Problem<Motion>& problem, const BlockPattern& pattern,
    std::vector<typename Motion::State> states);

/// Positions by linear least squares, with orientations as they are. False where arcs leave one
/// undetermined.
template <class Motion>
bool put_in_place(const Problem<Motion>& problem, const BlockPattern& pattern,
                  std::vector<typename Motion::State>& states);

}  // namespace portolan
