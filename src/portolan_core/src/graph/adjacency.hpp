// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan {

/// The accepted arcs around each pose of a graph, by index instead of by id.
class Adjacency {
 public:
  struct Neighbour {
    std::size_t pose;
    std::size_t arc;
  };
  struct Neighbours {
    const Neighbour* first;
    const Neighbour* last;
    const Neighbour* begin() const { return first; }
    const Neighbour* end() const { return last; }
  };

  explicit Adjacency(const Graph& graph);

  /// In the order of the arcs.
  Neighbours of(std::size_t pose) const {
    return {neighbours_.data() + begin_[pose], neighbours_.data() + begin_[pose + 1]};
  }

 private:
  std::vector<std::size_t> begin_;  // by pose, into neighbours_; one more at the end
  std::vector<Neighbour> neighbours_;
};

}  // namespace portolan
