// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graph/block_pattern.hpp"
#include "graph/problem.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {

/// A loop in the plane whose turns may add up to a whole turn more, or less, than they do.
struct OtherWinding {
  std::size_t term;  ///< that closes the loop
  double turn;       ///< that would be left over there, instead of up to half a turn [rad]
  double price;      ///< what headings alone would add to chi^2
};

/// By term: what is left of the turns round the loop that it closes with the tree; 0 for those of
/// the tree and between its parts. Along the tree turns add up from the root, so that this is not
/// wrapped: beyond half a turn the loop was wound up.
std::vector<double> turns_round_loops(const Problem<PlanarMotion>& problem,
                                      const SpanningTree& tree,
                                      const std::vector<PlanarMotion::State>& states);

/// Loops that the headings would not mind much to see wound another way, by increasing price up to
/// a highest one. In space there are none: turns do not add up there.
std::vector<OtherWinding> other_windings(const Problem<PlanarMotion>& problem,
                                         const SpanningTree& tree,
                                         const std::vector<PlanarMotion::State>& states,
                                         double highest_price);
std::vector<OtherWinding> other_windings(const Problem<SpatialMotion>& problem,
                                         const SpanningTree& tree,
                                         const std::vector<SpatialMotion::State>& states,
                                         double highest_price);

/// Headings as linear least squares have them with that loop wound the other way, and positions to
/// go with them; none where arcs leave them open.
std::optional<std::vector<PlanarMotion::State>> rewound(const Problem<PlanarMotion>& problem,
                                                        const BlockPattern& pattern,
                                                        std::vector<PlanarMotion::State> states,
                                                        const OtherWinding& winding);
std::optional<std::vector<SpatialMotion::State>> rewound(
    const Problem<SpatialMotion>& problem, const BlockPattern& pattern,
    const std::vector<SpatialMotion::State>& states, const OtherWinding& winding);

}  // namespace portolan
