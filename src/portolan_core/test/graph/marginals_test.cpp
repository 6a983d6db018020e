// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/marginals.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <stdexcept>

#include "graph/normal_equations.hpp"
#include "graph/random_graph.hpp"
#include "portolan/graph/graph_optimizer.hpp"

namespace portolan {
namespace {

Graph solved(GraphSpace space, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RandomGraph made;
  made.space = space;
  made.poses = 40;
  made.loops = 25;
  Graph graph = made.walk(random).graph;
  GraphOptimizer().optimize(graph);
  return graph;
}

// Chain of two: variances along x add up, and what the first turns swings the second.
TEST(Marginals, add_up_along_a_chain) {
  Graph graph;
  for (PoseId id = 0; id < 3; ++id) {
    GraphPose pose;
    pose.id = id;
    pose.T_map_pose = planar_pose(2.0 * static_cast<double>(id), 0.0, 0.0);
    graph.add(pose);
  }
  for (PoseId id = 0; id < 2; ++id) {
    Arc arc;
    arc.from = id;
    arc.to = id + 1;
    arc.T_from_to = planar_pose(2.0, 0.0, 0.0);
    arc.information.diagonal() << 1.0 / 0.04, 1.0 / 0.09, 1.0, 1.0, 1.0, 1.0 / 0.01;
    graph.add(arc);
  }
  const Marginals marginals(graph);
  const TangentMatrix covariance = marginals.covariance(2);
  EXPECT_NEAR(covariance(0, 0), 0.08, 1e-12);
  EXPECT_NEAR(covariance(1, 1), 0.18 + 2.0 * 2.0 * 0.01, 1e-12);
  EXPECT_NEAR(covariance(5, 5), 0.02, 1e-12);
  EXPECT_NEAR(covariance(1, 5), 2.0 * 0.01, 1e-12);
  EXPECT_EQ(covariance(2, 2), 0.0);
  EXPECT_EQ(marginals.covariance(0), TangentMatrix::Zero());
  EXPECT_NEAR(marginals.relative_covariance(1, 2)(1, 1), 0.09, 1e-12);
  EXPECT_NEAR(marginals.relative_covariance(2, 1)(5, 5), 0.01, 1e-12);
  EXPECT_LT(marginals.relative_covariance(1, 1).norm(), 1e-12);
  EXPECT_TRUE(marginals.relative_covariance(0, 2).isApprox(covariance, 1e-9));
  EXPECT_THROW(marginals.covariance(7), std::out_of_range);
}

template <class Motion>
void expect_dense_inverse(GraphSpace space) {
  constexpr int kSize = Motion::kSize;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Graph graph = solved(space, seed);
    const Problem<Motion> problem(graph, spanning_tree(graph));
    NormalEquations<Motion> equations(problem);
    equations.linearize(problem, problem.states(graph), Kernel());
    Eigen::MatrixXd dense(equations.g.size(), equations.g.size());
    for (Eigen::Index i = 0; i < dense.cols(); ++i) {
      Eigen::VectorXd column(dense.rows());
      equations.H.multiply(Eigen::VectorXd::Unit(dense.rows(), i), column);
      dense.col(i) = column;
    }
    const Eigen::MatrixXd inverse = dense.inverse();
    const Marginals marginals(graph);
    const auto all = marginals.covariances();
    for (std::size_t i = 0; i < problem.pose.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i) * kSize;
      const typename Motion::Matrix expected = inverse.block<kSize, kSize>(at, at);
      const std::size_t pose = problem.pose[i];
      EXPECT_TRUE(Motion::information(all[pose]).isApprox(expected, 1e-7)) << seed;
      if (i % 7 != 0) continue;
      const TangentMatrix single = marginals.covariance(graph.poses()[pose].id);
      EXPECT_TRUE(single.isApprox(all[pose], 1e-7)) << seed;
    }
  }
}

TEST(Marginals, are_blocks_of_the_dense_inverse) {
  expect_dense_inverse<PlanarMotion>(GraphSpace::planar);
  expect_dense_inverse<SpatialMotion>(GraphSpace::spatial);
}

// Fixing one end makes the other's covariance the relative one.
TEST(Marginals, of_two_poses_are_what_fixing_one_gives) {
  for (const GraphSpace space : {GraphSpace::planar, GraphSpace::spatial}) {
    Graph graph = solved(space, 11);
    const TangentMatrix relative = Marginals(graph).relative_covariance(3 * 9, 3 * 30);
    graph.fix(9, true);
    EXPECT_TRUE(Marginals(graph).covariance(3 * 30).isApprox(relative, 1e-6));
  }
}

TEST(Marginals, of_what_is_undetermined_there_are_none) {
  Graph graph = solved(GraphSpace::planar, 1);
  GraphPose loose;
  loose.id = 1000;
  graph.add(loose);
  Arc arc;
  arc.from = 0;
  arc.to = 1000;
  arc.information(1, 1) = 0.0;
  graph.add(arc);
  EXPECT_THROW(Marginals{graph}, std::runtime_error);
}

}  // namespace
}  // namespace portolan
