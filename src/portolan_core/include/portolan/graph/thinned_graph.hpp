// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/graph.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {

/// A chain of keyframes without some of them: neighbours of one that went are neighbours now, and
/// the arcs between them say what those over it said, T_a_c = T_a_b T_b_c. Its accepted loops are
/// carried on to the neighbour before, with that step's covariance added, and as far from closing
/// as they were; not if only their later end went, and the neighbour has such a loop already.
struct ThinnedGraph {
  Graph graph;                       ///< ids from 0 on
  std::vector<UncertainPose> steps;  ///< to each keyframe from the one before
  std::vector<std::size_t> arcs;     ///< for each of the graph's, which one it was
};

/// `graph` holds such a chain with ids from 0 on and consistent coordinates, `steps` lead along it.
/// Those that go, by increasing index, are no neighbours of each other and not at the ends; other
/// loops than accepted ones go with them.
ThinnedGraph thinned(const Graph& graph, const std::vector<UncertainPose>& steps,
                     const std::vector<std::size_t>& spare);

}  // namespace portolan
