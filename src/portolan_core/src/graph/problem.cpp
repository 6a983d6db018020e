// SPDX-License-Identifier: BSD-3-Clause
#include "graph/problem.hpp"

#include <algorithm>
#include <tuple>

namespace portolan {

namespace {

// Numbers the pairs of nodes that terms connect: by increasing nodes, each once.
template <class Motion>
std::vector<std::pair<int, int>> number_pairs(const std::vector<int>& node,
                                              std::vector<typename Problem<Motion>::Term>& terms) {
  std::vector<std::tuple<int, int, std::size_t>> sorted;
  sorted.reserve(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const int a = node[terms[i].from];
    const int b = node[terms[i].to];
    terms[i].swapped = b < a;
    if (a >= 0 && b >= 0) sorted.emplace_back(std::min(a, b), std::max(a, b), i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b, term] : sorted) {
    if (pairs.empty() || pairs.back() != std::make_pair(a, b)) pairs.emplace_back(a, b);
    terms[term].pair = static_cast<int>(pairs.size()) - 1;
  }
  return pairs;
}

}  // namespace

template <class Motion>
Problem<Motion>::Problem(const Graph& graph, const SpanningTree& tree) {
  for (std::size_t i = 0; i < graph.poses().size(); ++i) {
    const bool free = tree.parent[i] != SpanningTree::kNone;
    node.push_back(free ? static_cast<int>(pose.size()) : -1);
    if (free) pose.push_back(i);
  }
  terms.reserve(graph.arcs().size());
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const Arc& from_to = graph.arcs()[i];
    if (from_to.state != ArcState::accepted) continue;
    arc.push_back(i);
    terms.push_back({*graph.find(from_to.from), *graph.find(from_to.to), -1, false,
                     from_to.kind != ArcKind::odometry, Motion::state(from_to.T_from_to),
                     Motion::information(from_to.information)});
  }
  pairs = number_pairs<Motion>(node, terms);
}

template <class Motion>
std::vector<typename Motion::State> Problem<Motion>::states(const Graph& graph) const {
  std::vector<State> all;
  all.reserve(graph.poses().size());
  for (const GraphPose& from : graph.poses()) all.push_back(Motion::state(from.T_map_pose));
  return all;
}

template struct Problem<PlanarMotion>;
template struct Problem<SpatialMotion>;

}  // namespace portolan
