// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan::testing {

/// How well the arcs of a `GraphWalk` are measured, and what they say of it.
struct GraphNoise {
  double length = 0.05;  ///< standard deviation of positions [m]
  double turn = 0.02;    ///< of turns about each axis [rad]
  double tilt = 0.0;     ///< how far entries of the information's root leave the diagonal; below 1
  double decades = 0.0;  ///< arcs are up to so many powers of ten surer, or less sure, than others
  double boast = 1.0;    ///< times as sure as they are, in standard deviations
  std::uint64_t seed = 7;
};

/// A walk along true poses that measures relative poses with noise: a pose graph to solve, whose
/// poses are as odometry has them.
class GraphWalk {
 public:
  GraphWalk(GraphSpace space, const GraphNoise& noise)
      : graph_(space), noise_(noise), random_(noise.seed) {}

  /// The next pose, measured from the last one.
  void go_to(const Pose& T_world_robot) {
    GraphPose pose;
    pose.id = static_cast<PoseId>(truth_.size());
    truth_.push_back(T_world_robot);
    graph_.add(pose);
    if (truth_.size() == 1) return graph_.move(0, T_world_robot);
    const std::size_t last = truth_.size() - 2;
    measure(last, last + 1, ArcKind::odometry);
    graph_.move(last + 1, graph_.poses()[last].T_map_pose * graph_.arcs().back().T_from_to);
  }

  /// Of two poses by their numbers on the walk.
  void measure(std::size_t from, std::size_t to, ArcKind kind = ArcKind::loop) {
    std::uniform_real_distribution<double> decade(-0.5 * noise_.decades, 0.5 * noise_.decades);
    const TangentMatrix root = information_root() * std::pow(10.0, decade(random_));
    Arc arc;
    arc.from = static_cast<PoseId>(from);
    arc.to = static_cast<PoseId>(to);
    arc.kind = kind;
    arc.T_from_to = truth_[from].inverse() * truth_[to] * moved(root);
    arc.information = noise_.boast * noise_.boast * root.transpose() * root;
    graph_.add(arc);
  }

  std::size_t size() const { return truth_.size(); }
  const std::vector<Pose>& truth() const { return truth_; }
  const Graph& graph() const { return graph_; }
  std::mt19937_64& random() { return random_; }

 private:
  TangentMatrix information_root() {
    std::uniform_real_distribution<double> tilt(-noise_.tilt, noise_.tilt);
    TangentMatrix root = TangentMatrix::Identity();
    for (int i = 0; i < 36 && noise_.tilt > 0.0; ++i) root(i / 6, i % 6) += tilt(random_);
    root.leftCols<3>() /= noise_.length;
    root.rightCols<3>() /= noise_.turn;
    if (graph_.space() == GraphSpace::spatial) return root;
    for (const int i : {2, 3, 4}) {  // in the plane, these stay
      root.row(i).setZero();
      root.col(i).setZero();
      root(i, i) = 1.0;
    }
    return root;
  }

  // By noise whose information is root^T root.
  Pose moved(const TangentMatrix& root) {
    Tangent white;
    for (int i = 0; i < 6; ++i) white[i] = normal_(random_);
    const Tangent v = root.partialPivLu().solve(white);
    if (graph_.space() == GraphSpace::planar) return planar_pose(v[0], v[1], v[5]);
    const Eigen::Vector3d turn = v.tail<3>();
    return Eigen::Translation3d(v.head<3>()) * Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }

  std::vector<Pose> truth_;
  Graph graph_;
  GraphNoise noise_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace portolan::testing
