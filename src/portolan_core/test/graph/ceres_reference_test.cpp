// SPDX-License-Identifier: BSD-3-Clause
// The optimiser against an independent one, where that is installed.
#ifdef PORTOLAN_HAS_CERES

#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <memory>
#include <random>
#include <vector>

#include "graph/random_graph.hpp"
#include "portolan/graph/graph_optimizer.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {
namespace {

using Moves = std::vector<std::array<double, 6>>;  // by pose: what moves it from where it started

// sqrt(information) times the residual of an arc, derived automatically.
struct ArcResidual {
  Pose T_map_from;
  Pose T_map_to;
  Pose T_from_to;
  TangentMatrix root;

  template <class T>
  static void moved(const Pose& pose, const T* v, Eigen::Matrix<T, 3, 1>& t,
                    Eigen::Quaternion<T>& q) {
    const Eigen::Matrix<T, 3, 3> R = pose.linear().cast<T>();
    t = pose.translation().cast<T>() + R * Eigen::Matrix<T, 3, 1>(v[0], v[1], v[2]);
    T wxyz[4];
    ceres::AngleAxisToQuaternion(v + 3, wxyz);
    q = Eigen::Quaterniond(pose.linear()).cast<T>() *
        Eigen::Quaternion<T>(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  }

  template <class T>
  bool operator()(const T* v_from, const T* v_to, T* residual) const {
    Eigen::Matrix<T, 3, 1> t_from, t_to;
    Eigen::Quaternion<T> q_from, q_to;
    moved(T_map_from, v_from, t_from, q_from);
    moved(T_map_to, v_to, t_to, q_to);
    const Eigen::Quaternion<T> q_measured = Eigen::Quaterniond(T_from_to.linear()).cast<T>();
    const Eigen::Matrix<T, 3, 1> t = q_from.conjugate() * (t_to - t_from);
    Eigen::Quaternion<T> q = q_measured.conjugate() * (q_from.conjugate() * q_to);
    if (q.w() < T(0.0)) q.coeffs() = -q.coeffs();
    Eigen::Matrix<T, 6, 1> r;
    r << q_measured.conjugate() * (t - T_from_to.translation().cast<T>()), T(2.0) * q.vec();
    Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(residual);
    weighted = root.cast<T>() * r;
    return true;
  }
};

// The least chi^2 that Ceres finds from the spanning tree. Planar graphs move in space, too, but
// nothing pulls them out of the plane: what it costs to leave is decoupled from the rest.
double least_chi2(const Graph& graph) {
  Graph start = graph;
  place_along(spanning_tree(graph), start);
  Moves moves(graph.poses().size(), std::array<double, 6>{});
  ceres::Problem problem;
  for (auto& move : moves) problem.AddParameterBlock(move.data(), 6);
  for (const Arc& arc : graph.arcs()) {
    TangentMatrix information = arc.information;
    if (graph.space() == GraphSpace::planar) {
      for (const int i : {2, 3, 4}) {
        information.row(i).setZero();
        information.col(i).setZero();
        information(i, i) = 1.0;
      }
    }
    auto* residual = new ArcResidual{start.at(arc.from).T_map_pose, start.at(arc.to).T_map_pose,
                                     arc.T_from_to, information.llt().matrixU()};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ArcResidual, 6, 6, 6>(residual),
                             nullptr, moves[*graph.find(arc.from)].data(),
                             moves[*graph.find(arc.to)].data());
  }
  problem.SetParameterBlockConstant(moves[0].data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return 2.0 * summary.final_cost;
}

// In space, and in the plane where 2 sin(turn / 2) is not yet different from the turn.
TEST(CeresReference, finds_no_better_coordinates) {
  for (const GraphSpace space : {GraphSpace::planar, GraphSpace::spatial}) {
    const double difference = space == GraphSpace::planar ? 1e-2 : 1e-6;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      std::mt19937_64 random(seed);
      RandomGraph made;
      made.space = space;
      made.noise = 0.5;
      Graph graph = made.walk(random).graph;
      const double reference = least_chi2(graph);
      const OptimizerReport report = GraphOptimizer().optimize(graph);
      EXPECT_TRUE(report.doubts.empty()) << seed << to_string(report.doubts);
      EXPECT_NEAR(report.chi2, reference, difference * reference) << seed;
    }
  }
}

}  // namespace
}  // namespace portolan

#endif
