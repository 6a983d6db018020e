// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>

#include "portolan/graph/graph.hpp"

namespace portolan {

/// A walk with loops, as measured: arcs between consecutive poses, and to poses that it came near
/// again. Poses are as odometry has them.
struct RandomGraph {
  GraphSpace space = GraphSpace::planar;
  std::size_t poses = 60;
  std::size_t loops = 30;
  double noise = 1.0;  ///< times what the information says

  struct Walk {
    std::vector<Pose> truth;
    Graph graph;
  };
  Walk walk(std::mt19937_64& random) const;
};

namespace random_graph_detail {

inline Pose small_motion(GraphSpace space, double length, double turn, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  if (space == GraphSpace::planar) {
    return planar_pose(length * normal(random), length * normal(random), turn * normal(random));
  }
  Eigen::Vector3d axis(normal(random), normal(random), normal(random));
  const double angle = axis.norm();
  Pose motion = Pose::Identity();
  motion.linear() = Eigen::AngleAxisd(turn * angle, axis / angle).toRotationMatrix();
  for (int i = 0; i < 3; ++i) motion.translation()[i] = length * normal(random);
  return motion;
}

// Some place for the first pose, a metre ahead for any other.
inline Pose next_pose(GraphSpace space, const std::vector<Pose>& way, std::mt19937_64& random) {
  if (way.empty()) return small_motion(space, 5.0, 1.0, random);
  Pose step = small_motion(space, 0.1, 0.5, random);
  step.translation().x() += 1.0;
  return way.back() * step;
}

// Not a multiple of unity, so that every entry is used.
inline TangentMatrix random_information(double length, double turn, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  TangentMatrix root = TangentMatrix::Identity();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) root(i, j) += uniform(random);
  }
  root.topRows<3>() /= length;
  root.bottomRows<3>() /= turn;
  return root.transpose() * root;
}

}  // namespace random_graph_detail

inline RandomGraph::Walk RandomGraph::walk(std::mt19937_64& random) const {
  using random_graph_detail::random_information;
  using random_graph_detail::small_motion;
  constexpr double kLength = 0.05;
  constexpr double kTurn = 0.03;
  Walk walk{{}, Graph(space)};
  const auto measure = [&](std::size_t from, std::size_t to, ArcKind kind) {
    Arc arc;
    arc.from = static_cast<PoseId>(3 * from);
    arc.to = static_cast<PoseId>(3 * to);
    arc.kind = kind;
    arc.T_from_to = walk.truth[from].inverse() * walk.truth[to] *
                    small_motion(space, noise * kLength, noise * kTurn, random);
    arc.information = random_information(kLength, kTurn, random);
    walk.graph.add(arc);
  };
  for (std::size_t i = 0; i < poses; ++i) {
    walk.truth.push_back(random_graph_detail::next_pose(space, walk.truth, random));
    GraphPose pose;
    pose.id = static_cast<PoseId>(3 * i);
    pose.T_map_pose = walk.truth.back();
    walk.graph.add(pose);
    if (i == 0) continue;
    measure(i - 1, i, ArcKind::odometry);
    const Pose& T_map_last = walk.graph.poses()[i - 1].T_map_pose;
    walk.graph.move(i, T_map_last * walk.graph.arcs().back().T_from_to);
  }
  std::uniform_int_distribution<std::size_t> any(0, poses - 1);
  while (walk.graph.arcs().size() < poses - 1 + loops) {
    const std::size_t a = any(random);
    const std::size_t b = any(random);
    if (a != b) measure(a, b, ArcKind::loop);
  }
  return walk;
}

}  // namespace portolan
