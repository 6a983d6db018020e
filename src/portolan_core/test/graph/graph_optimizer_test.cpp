// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/graph_optimizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "graph/random_graph.hpp"

namespace portolan {
namespace {

Arc arc(PoseId from, PoseId to, const Pose& T_from_to, double stddev = 1.0) {
  Arc made;
  made.from = from;
  made.to = to;
  made.T_from_to = T_from_to;
  made.information /= stddev * stddev;
  return made;
}

Graph chain(std::size_t poses) {
  Graph graph;
  for (std::size_t i = 0; i < poses; ++i) {
    GraphPose pose;
    pose.id = static_cast<PoseId>(i);
    graph.add(pose);
  }
  return graph;
}

double largest_difference(const Graph& a, const Graph& b, const Pose& T_a_b = Pose::Identity()) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.poses().size(); ++i) {
    const Pose moved = T_a_b * b.poses()[i].T_map_pose;
    const auto difference = a.poses()[i].T_map_pose.matrix() - moved.matrix();
    largest = std::max(largest, difference.cwiseAbs().maxCoeff());
  }
  return largest;
}

// By hand: 0 -> 1 says 1 m, 1 -> 2 says 1 m, 0 -> 2 says 2.3 m; all equally sure, so each takes a
// third of the 0.3 m, and chi^2 is 3 * 0.1^2.
TEST(GraphOptimizer, shares_a_contradiction_among_equals) {
  Graph graph = chain(3);
  graph.add(arc(0, 1, planar_pose(1.0, 0.0, 0.0)));
  graph.add(arc(1, 2, planar_pose(1.0, 0.0, 0.0)));
  graph.add(arc(0, 2, planar_pose(2.3, 0.0, 0.0)));
  const OptimizerReport report = GraphOptimizer().optimize(graph);
  EXPECT_NEAR(report.chi2, 0.03, 1e-12);
  EXPECT_EQ(report.degrees_of_freedom, 3U);
  EXPECT_TRUE(report.doubts.empty()) << to_string(report.doubts);
  EXPECT_TRUE(graph.at(1).T_map_pose.isApprox(planar_pose(1.1, 0.0, 0.0), 1e-9));
  EXPECT_TRUE(graph.at(2).T_map_pose.isApprox(planar_pose(2.2, 0.0, 0.0), 1e-9));
}

// By hand: of a contradiction of 0.3 m the arc of variance 4 takes 4/6, those of variance 1 1/6.
TEST(GraphOptimizer, believes_the_surer_arcs_more) {
  Graph graph = chain(3);
  graph.add(arc(0, 1, planar_pose(1.0, 0.0, 0.0)));
  graph.add(arc(1, 2, planar_pose(1.0, 0.0, 0.0)));
  graph.add(arc(2, 0, planar_pose(-2.3, 0.0, 0.0), 2.0));
  GraphOptimizer().optimize(graph);
  EXPECT_NEAR(graph.at(2).T_map_pose.translation().x(), 2.1, 1e-9);
}

TEST(GraphOptimizer, closes_a_square) {
  Graph graph = chain(4);
  for (PoseId i = 0; i < 4; ++i) graph.add(arc(i, (i + 1) % 4, planar_pose(1.0, 0.0, 1.6)));
  const OptimizerReport report = GraphOptimizer().optimize(graph);
  EXPECT_TRUE(report.doubts.empty()) << to_string(report.doubts);
  EXPECT_NEAR(std::abs(yaw(graph.at(2).T_map_pose)), M_PI, 1e-6);
  EXPECT_TRUE(
      graph.at(2).T_map_pose.translation().head<2>().isApprox(Eigen::Vector2d(1.0, 1.0), 0.05));
}

TEST(GraphOptimizer, leaves_what_is_fixed) {
  Graph graph = chain(3);
  graph.move(2, planar_pose(5.0, 0.0, 0.0));
  graph.fix(0, true);
  graph.fix(2, true);
  graph.add(arc(0, 1, planar_pose(1.0, 0.0, 0.0)));
  graph.add(arc(1, 2, planar_pose(1.0, 0.0, 0.0)));
  const OptimizerReport report = GraphOptimizer().optimize(graph);
  EXPECT_TRUE(graph.at(2).T_map_pose.isApprox(planar_pose(5.0, 0.0, 0.0)));
  EXPECT_NEAR(graph.at(1).T_map_pose.translation().x(), 2.5, 1e-9);
  EXPECT_EQ(report.doubts.count(Doubt::disconnected), 0U);
}

TEST(GraphOptimizer, takes_graphs_with_nothing_to_move) {
  Graph none;
  EXPECT_EQ(GraphOptimizer().optimize(none).chi2, 0.0);
  Graph one = chain(1);
  EXPECT_TRUE(GraphOptimizer().optimize(one).doubts.empty());
  Graph apart = chain(2);
  EXPECT_EQ(GraphOptimizer().optimize(apart).doubts, std::set<Doubt>{Doubt::disconnected});
}

TEST(GraphOptimizer, doubts_what_arcs_leave_open) {
  Graph graph = chain(2);
  Arc open = arc(0, 1, planar_pose(1.0, 0.0, 0.0));
  open.information(1, 1) = 0.0;
  graph.add(open);
  EXPECT_EQ(GraphOptimizer().optimize(graph).doubts, std::set<Doubt>{Doubt::undetermined});
}

TEST(GraphOptimizer, doubts_arcs_without_information) {
  Graph graph = chain(2);
  graph.add(arc(0, 1, planar_pose(1.0, 0.0, 0.0)));
  Arc bad = arc(0, 1, planar_pose(3.0, 0.0, 0.0));
  bad.information(0, 0) = -1.0;
  graph.add(bad);
  EXPECT_EQ(GraphOptimizer().optimize(graph).doubts, std::set<Doubt>{Doubt::bad_information});
  EXPECT_NEAR(graph.at(1).T_map_pose.translation().x(), 1.0, 1e-9);
}

TEST(GraphOptimizer, doubts_arcs_that_contradict_each_other) {
  Graph graph = chain(2);
  graph.add(arc(0, 1, planar_pose(1.0, 0.0, 0.0), 0.01));
  graph.add(arc(0, 1, planar_pose(2.0, 0.0, 0.0), 0.01));
  EXPECT_EQ(GraphOptimizer().optimize(graph).doubts.count(Doubt::poor_fit), 1U);
}

// A ring whose turns were started a whole turn off stays there: each arc takes a little of it.
TEST(GraphOptimizer, does_not_stay_in_a_minimum_that_is_wound_up) {
  constexpr PoseId kPoses = 40;
  Graph graph = chain(kPoses);
  for (PoseId i = 0; i < kPoses; ++i) {
    graph.add(arc(i, (i + 1) % kPoses, planar_pose(1.0, 0.0, 2.0 * M_PI / kPoses), 0.1));
  }
  for (PoseId i = 0; i < kPoses; ++i) {
    const double angle = 4.0 * M_PI * static_cast<double>(i) / kPoses;
    graph.move(static_cast<std::size_t>(i),
               planar_pose(2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle), angle));
  }
  OptimizerOptions options;
  options.start = GraphStart::as_given;
  const OptimizerReport report = GraphOptimizer(options).optimize(graph);
  EXPECT_LT(report.chi2, 1e-6);
  EXPECT_EQ(report.doubts, std::set<Doubt>{Doubt::other_minimum});
}

TEST(GraphOptimizer, takes_weight_from_wrong_loops_by_each_kernel) {
  for (const RobustKernel kernel :
       {RobustKernel::huber, RobustKernel::cauchy, RobustKernel::geman_mcclure}) {
    std::mt19937_64 random(5);
    RandomGraph::Walk walk = RandomGraph{}.walk(random);
    OptimizerOptions options;
    options.kernel = kernel;
    Graph right = walk.graph;
    GraphOptimizer(options).optimize(right);
    Arc wrong = walk.graph.arcs().back();
    wrong.T_from_to = wrong.T_from_to * planar_pose(4.0, -3.0, 1.0);
    const std::size_t index = walk.graph.add(wrong);
    const OptimizerReport report = GraphOptimizer(options).optimize(walk.graph);
    EXPECT_LT(report.weights[index], 0.1) << static_cast<int>(kernel);
    EXPECT_EQ(report.weights[0], 1.0);
    EXPECT_LT(largest_difference(right, walk.graph), 0.2) << static_cast<int>(kernel);
  }
}

class GraphOptimizerLaws : public ::testing::TestWithParam<GraphSpace> {
 protected:
  RandomGraph::Walk walk(std::uint64_t seed, double noise = 1.0) const {
    std::mt19937_64 random(seed);
    RandomGraph made;
    made.space = GetParam();
    made.noise = noise;
    return made.walk(random);
  }
};

TEST_P(GraphOptimizerLaws, finds_the_truth_without_noise) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RandomGraph::Walk exact = walk(seed, 0.0);
    const OptimizerReport report = GraphOptimizer().optimize(exact.graph);
    EXPECT_TRUE(report.doubts.empty()) << to_string(report.doubts);
    EXPECT_LT(report.chi2, 1e-12);
    for (std::size_t i = 0; i < exact.truth.size(); ++i) {
      EXPECT_TRUE(exact.graph.poses()[i].T_map_pose.isApprox(exact.truth[i], 1e-8)) << seed;
    }
  }
}

TEST_P(GraphOptimizerLaws, fits_as_well_as_the_noise_lets_it) {
  double chi2 = 0.0;
  double degrees = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomGraph::Walk noisy = walk(seed, 0.5);
    const OptimizerReport report = GraphOptimizer().optimize(noisy.graph);
    EXPECT_TRUE(report.doubts.empty()) << seed << to_string(report.doubts);
    EXPECT_LE(report.chi2, report.chi2_before);
    chi2 += report.chi2;
    degrees += static_cast<double>(report.degrees_of_freedom);
  }
  EXPECT_GT(chi2, 0.1 * degrees);
  EXPECT_LT(chi2, 1.0 * degrees);
}

TEST_P(GraphOptimizerLaws, does_not_care_where_the_map_begins) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    RandomGraph::Walk here = walk(seed);
    Graph there = here.graph;
    std::mt19937_64 random(seed);
    const Pose T_there_here = random_graph_detail::small_motion(GetParam(), 10.0, 1.0, random);
    for (std::size_t i = 0; i < there.poses().size(); ++i) {
      there.move(i, T_there_here * there.poses()[i].T_map_pose);
    }
    const OptimizerReport a = GraphOptimizer().optimize(here.graph);
    const OptimizerReport b = GraphOptimizer().optimize(there);
    EXPECT_NEAR(a.chi2, b.chi2, 1e-6 * a.chi2);
    EXPECT_LT(largest_difference(there, here.graph, T_there_here), 1e-4) << seed;
  }
}

TEST_P(GraphOptimizerLaws, does_not_care_for_the_order_of_arcs) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    RandomGraph::Walk ordered = walk(seed);
    Graph shuffled(GetParam());
    for (const GraphPose& pose : ordered.graph.poses()) shuffled.add(pose);
    std::vector<Arc> arcs = ordered.graph.arcs();
    std::mt19937_64 random(seed);
    std::shuffle(arcs.begin(), arcs.end(), random);
    for (const Arc& from_to : arcs) shuffled.add(from_to);
    const OptimizerReport a = GraphOptimizer().optimize(ordered.graph);
    const OptimizerReport b = GraphOptimizer().optimize(shuffled);
    EXPECT_NEAR(a.chi2, b.chi2, 1e-6 * a.chi2);
    EXPECT_LT(largest_difference(ordered.graph, shuffled), 1e-4) << seed;
  }
}

TEST_P(GraphOptimizerLaws, takes_a_disabled_arc_as_an_absent_one_bit_for_bit) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    RandomGraph::Walk absent = walk(seed);
    RandomGraph::Walk disabled = absent;
    Arc wrong = absent.graph.arcs().back();
    wrong.T_from_to = wrong.T_from_to * planar_pose(4.0, 3.0, 1.0);
    const std::size_t index = disabled.graph.add(wrong);
    disabled.graph.set_state(index, ArcState::disabled, ArcReason::by_request);
    GraphOptimizer().optimize(absent.graph);
    GraphOptimizer().optimize(disabled.graph);
    EXPECT_EQ(largest_difference(absent.graph, disabled.graph), 0.0) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, GraphOptimizerLaws,
                         ::testing::Values(GraphSpace::planar, GraphSpace::spatial));

}  // namespace
}  // namespace portolan
