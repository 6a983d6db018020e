// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/spanning_tree.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "graph/adjacency.hpp"

namespace portolan {

namespace {

constexpr std::size_t kNone = SpanningTree::kNone;
constexpr double kUnknown = 1e12;  // variance of directions of which an arc says nothing

// A way to a pose that was found and may not be the surest one.
struct Way {
  double length;
  std::size_t pose;
  std::size_t arc;
  bool operator>(const Way& other) const {
    return std::tie(length, arc, pose) > std::tie(other.length, other.arc, other.pose);
  }
};

// By the Cholesky factor L: the sum of the squares of L^-1, row by row.
template <int n>
double trace_of_inverse(Eigen::Matrix<double, n, n> L) {
  Eigen::Matrix<double, n, n> root;  // L^-1
  double trace = 0.0;
  for (int i = 0; i < n; ++i) {
    double pivot = L(i, i) + 1.0 / kUnknown;
    for (int k = 0; k < i; ++k) {
      for (int l = 0; l < k; ++l) L(i, k) -= L(i, l) * L(k, l);
      L(i, k) *= root(k, k);
      pivot -= L(i, k) * L(i, k);
    }
    if (!(pivot > 0.0)) return kUnknown;
    root(i, i) = 1.0 / std::sqrt(pivot);
    trace += root(i, i) * root(i, i);
    for (int j = 0; j < i; ++j) {
      double sum = 0.0;
      for (int k = j; k < i; ++k) sum += L(i, k) * root(k, j);
      root(i, j) = -sum * root(i, i);
      trace += root(i, j) * root(i, j);
    }
  }
  return trace;
}

double uncertainty(const Arc& arc, GraphSpace space) {
  const TangentMatrix& m = arc.information;
  if (space == GraphSpace::spatial) return trace_of_inverse<6>(m);
  Eigen::Matrix3d planar;
  planar << m.topLeftCorner<2, 2>(), m.block<2, 1>(0, 5), m.block<1, 2>(5, 0), m(5, 5);
  return trace_of_inverse<3>(planar);
}

// Dijkstra's algorithm from several roots, one after the other.
class Growth {
 public:
  explicit Growth(const Graph& graph) : graph_(graph), arcs_around_(graph) {
    const std::size_t n = graph.poses().size();
    tree_.order.reserve(n);
    tree_.arc_to.assign(n, kNone);
    tree_.parent.assign(n, kNone);
    tree_.component.assign(n, kNone);
    lengths_.assign(n, std::numeric_limits<double>::infinity());
    uncertainties_.reserve(graph.arcs().size());
    for (const Arc& arc : graph.arcs()) uncertainties_.push_back(uncertainty(arc, graph.space()));
  }

  SpanningTree grown() {
    for (std::size_t pose = 0; pose < graph_.poses().size(); ++pose) {
      if (graph_.poses()[pose].fixed) plant(pose);
    }
    grow();
    for (std::size_t pose = 0; pose < graph_.poses().size(); ++pose) {
      if (reached(pose)) continue;
      plant(pose);
      grow();
    }
    return std::move(tree_);
  }

 private:
  bool reached(std::size_t pose) const { return tree_.component[pose] != kNone; }

  void plant(std::size_t root) {
    tree_.component[root] = tree_.components++;
    tree_.order.push_back(root);
    lengths_[root] = 0.0;
    look_around(root);
  }

  void look_around(std::size_t pose) {
    for (const Adjacency::Neighbour& next : arcs_around_.of(pose)) {
      if (reached(next.pose)) continue;
      const double length = lengths_[pose] + uncertainties_[next.arc];
      if (length >= lengths_[next.pose]) continue;
      lengths_[next.pose] = length;
      tree_.parent[next.pose] = pose;
      tree_.arc_to[next.pose] = next.arc;
      ways_.push({length, next.pose, next.arc});
    }
  }

  void grow() {
    while (!ways_.empty()) {
      const Way way = ways_.top();
      ways_.pop();
      if (reached(way.pose)) continue;
      tree_.component[way.pose] = tree_.component[tree_.parent[way.pose]];
      tree_.order.push_back(way.pose);
      look_around(way.pose);
    }
  }

  const Graph& graph_;
  Adjacency arcs_around_;
  std::vector<double> uncertainties_;  // by arc
  std::vector<double> lengths_;        // by pose, of the surest way known
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways_;
  SpanningTree tree_;
};

}  // namespace

SpanningTree spanning_tree(const Graph& graph) { return Growth(graph).grown(); }

void place_along(const SpanningTree& tree, Graph& graph) {
  for (const std::size_t pose : tree.order) {
    if (tree.parent[pose] == kNone) continue;
    const GraphPose& parent = graph.poses()[tree.parent[pose]];
    const Arc& arc = graph.arcs()[tree.arc_to[pose]];
    const Pose T_parent_pose = arc.from == parent.id ? arc.T_from_to : arc.T_from_to.inverse();
    graph.move(pose, parent.T_map_pose * T_parent_pose);
  }
}

}  // namespace portolan
