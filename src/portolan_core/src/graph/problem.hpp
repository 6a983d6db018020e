// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "graph/block_matrix.hpp"
#include "graph/planar_motion.hpp"
#include "graph/spatial_motion.hpp"
#include "portolan/graph/graph.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {

/// A graph as the optimiser reads it: only what counts, by index, in the motion's own coordinates.
template <class Motion>
struct Problem {
  using State = typename Motion::State;

  struct Term {
    std::size_t from;  ///< pose
    std::size_t to;    ///< pose
    int pair;          ///< of the matrix; -1 where an end is fixed
    bool swapped;      ///< the pair's first node is that of `to`
    bool may_fail;     ///< kernels apply: it is not odometry
    State measured;
    typename Motion::Matrix information;
  };

  /// Fixed are the poses that the graph says, and the roots of the tree.
  Problem(const Graph& graph, const SpanningTree& tree);

  std::vector<State> states(const Graph& graph) const;

  std::vector<int> node;          ///< by pose: its row in the matrix; -1: fixed
  std::vector<std::size_t> pose;  ///< by row
  std::vector<Term> terms;
  std::vector<std::size_t> arc;  ///< by term
  std::vector<std::pair<int, int>> pairs;
  bool has_bad_information = false;  ///< some arc was left out for it
};

}  // namespace portolan
