// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan {

/// The surest way from a root to each pose of a graph, along accepted arcs: chapter 8's spanning
/// tree by Dijkstra's algorithm. The length of an arc is the trace of its covariance, so ways are
/// compared by the uncertainty that they gather.
struct SpanningTree {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Poses by index of `Graph::poses()`, parents before children.
  std::vector<std::size_t> order;
  /// By pose: the arc that leads to it, by index of `Graph::arcs()`; `kNone` for roots.
  std::vector<std::size_t> arc_to;
  /// By pose: the pose where that arc begins; `kNone` for roots.
  std::vector<std::size_t> parent;
  /// By pose: how many roots came before its own; 0 in a connected graph.
  std::vector<std::size_t> component;
  std::size_t components = 0;
};

/// Roots are the fixed poses or, in parts without any, the pose of the lowest id.
SpanningTree spanning_tree(const Graph& graph);

/// First coordinates: each pose where the tree's arcs lead from its root, which stays.
void place_along(const SpanningTree& tree, Graph& graph);

}  // namespace portolan
