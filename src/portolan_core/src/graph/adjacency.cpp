// SPDX-License-Identifier: BSD-3-Clause
#include "graph/adjacency.hpp"

#include <numeric>

namespace portolan {

Adjacency::Adjacency(const Graph& graph) : begin_(graph.poses().size() + 1, 0) {
  struct Ends {
    std::size_t from;
    std::size_t to;
    std::size_t arc;
  };
  std::vector<Ends> accepted;
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const Arc& arc = graph.arcs()[i];
    if (arc.state != ArcState::accepted) continue;
    accepted.push_back({*graph.find(arc.from), *graph.find(arc.to), i});
    ++begin_[accepted.back().from + 1];
    ++begin_[accepted.back().to + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  neighbours_.resize(2 * accepted.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const Ends& ends : accepted) {
    neighbours_[next[ends.from]++] = {ends.to, ends.arc};
    neighbours_[next[ends.to]++] = {ends.from, ends.arc};
  }
}

}  // namespace portolan
