// SPDX-License-Identifier: BSD-3-Clause
#include "graph/problem.hpp"

#include <algorithm>
#include <numeric>

namespace portolan {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Numbers the pairs of nodes that terms connect: by increasing nodes, each once. Terms are shared
// out by the lower node first, so that there is little left to sort.
template <class Motion>
std::vector<std::pair<int, int>> number_pairs(const std::vector<int>& node, std::size_t nodes,
                                              std::vector<typename Problem<Motion>::Term>& terms) {
  using Upper = std::pair<int, std::size_t>;   // the other node, and the term
  std::vector<std::size_t> end(nodes + 1, 0);  // by lower node
  const auto for_pairs = [&](const auto& use) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const auto [lower, upper] = std::minmax(node[terms[i].from], node[terms[i].to]);
      if (lower >= 0) use(at(lower), upper, i);
    }
  };
  for_pairs([&](std::size_t lower, int, std::size_t) { ++end[lower + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Upper> sorted(end.back());
  for_pairs([&](std::size_t lower, int upper, std::size_t term) {
    sorted[end[lower]++] = {upper, term};
  });
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(sorted.size());
  std::size_t begin = 0;
  for (std::size_t lower = 0; lower < nodes; begin = end[lower++]) {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(end[lower]));
    for (std::size_t i = begin; i < end[lower]; ++i) {
      const std::pair<int, int> pair(static_cast<int>(lower), sorted[i].first);
      if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
      terms[sorted[i].second].pair = static_cast<int>(pairs.size()) - 1;
    }
  }
  return pairs;
}

}  // namespace

template <class Motion>
Problem<Motion>::Problem(const Graph& graph, const SpanningTree& tree) {
  node.reserve(graph.poses().size());
  pose.reserve(graph.poses().size());
  for (std::size_t i = 0; i < graph.poses().size(); ++i) {
    const bool free = tree.parent[i] != SpanningTree::kNone;
    node.push_back(free ? static_cast<int>(pose.size()) : -1);
    if (free) pose.push_back(i);
  }
  terms.reserve(graph.arcs().size());
  arc.reserve(graph.arcs().size());
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const Arc& from_to = graph.arcs()[i];
    has_bad_information |= from_to.reason == ArcReason::bad_information;
    if (from_to.state != ArcState::accepted) continue;
    arc.push_back(i);
    const std::size_t from = *graph.find(from_to.from);
    const std::size_t to = *graph.find(from_to.to);
    terms.push_back({from, to, -1, node[to] < node[from], from_to.kind != ArcKind::odometry,
                     Motion::state(from_to.T_from_to), Motion::information(from_to.information)});
  }
  pairs = number_pairs<Motion>(node, pose.size(), terms);
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
