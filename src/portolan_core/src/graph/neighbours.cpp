// SPDX-License-Identifier: BSD-3-Clause
#include "graph/neighbours.hpp"

#include <numeric>

namespace portolan {

namespace {

// Sorts by counting: edges, seen from their second node, sorted stably by the first.
struct Half {
  int node;
  int neighbour;
};

std::vector<Half> sorted_by_node(const std::vector<Half>& halves, int size) {
  std::vector<std::size_t> next(static_cast<std::size_t>(size) + 1, 0);
  for (const Half& half : halves) ++next[static_cast<std::size_t>(half.node) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Half> sorted(halves.size());
  for (const Half& half : halves) sorted[next[static_cast<std::size_t>(half.node)]++] = half;
  return sorted;
}

void turn_round(std::vector<Half>& halves) {
  for (Half& half : halves) half = {half.neighbour, half.node};
}

}  // namespace

Neighbours::Neighbours(int size, const std::vector<std::pair<int, int>>& edges)
    : begin_(static_cast<std::size_t>(size) + 1, 0) {
  std::vector<Half> halves;
  halves.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    halves.push_back({b, a});
    halves.push_back({a, b});
  }
  halves = sorted_by_node(halves, size);
  turn_round(halves);
  halves = sorted_by_node(halves, size);
  all_.reserve(halves.size());
  std::size_t i = 0;
  for (int node = 0; node < size; ++node) {
    const std::size_t begin = all_.size();
    for (; i < halves.size() && halves[i].node == node; ++i) {
      if (all_.size() == begin || all_.back() != halves[i].neighbour) {
        all_.push_back(halves[i].neighbour);
      }
    }
    begin_[static_cast<std::size_t>(node) + 1] = static_cast<int>(all_.size());
  }
}

Neighbours Neighbours::renamed(const std::vector<int>& name) const {
  Neighbours graph;
  graph.begin_.resize(begin_.size(), 0);
  for (int node = 0; node < size(); ++node) {
    const Range around = of(node);
    graph.begin_[static_cast<std::size_t>(name[static_cast<std::size_t>(node)]) + 1] =
        static_cast<int>(around.end() - around.begin());
  }
  std::partial_sum(graph.begin_.begin(), graph.begin_.end(), graph.begin_.begin());
  graph.all_.resize(all_.size());
  for (int node = 0; node < size(); ++node) {
    int to = graph.begin_[static_cast<std::size_t>(name[static_cast<std::size_t>(node)])];
    for (const int next : of(node)) {
      graph.all_[static_cast<std::size_t>(to++)] = name[static_cast<std::size_t>(next)];
    }
  }
  return graph;
}

}  // namespace portolan
