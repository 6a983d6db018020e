// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/thinned_graph.hpp"

#include <gtest/gtest.h>

#include "graph/round_drive.hpp"
#include "portolan/graph/graph_optimizer.hpp"
#include "portolan/graph/restored_steps.hpp"

namespace portolan {
namespace {

const Drive& twice_round() {
  static const Drive kRun = [] {
    Drive made;
    drive(made, 0.0, 100.0);
    return made;
  }();
  return kRun;
}

std::vector<UncertainPose> steps_of(const Graph& graph) {
  std::vector<UncertainPose> steps;
  for (const RestoredStep& restored : restored_steps(graph)) steps.push_back(restored.step);
  return steps;
}

std::vector<std::size_t> every_second(const Graph& graph) {
  std::vector<std::size_t> spare;
  for (std::size_t i = 1; i + 1 < graph.poses().size(); i += 2) spare.push_back(i);
  return spare;
}

std::size_t accepted_loops(const Graph& graph) {
  const auto& arcs = graph.arcs();
  return static_cast<std::size_t>(std::count_if(arcs.begin(), arcs.end(), [](const Arc& arc) {
    return arc.kind == ArcKind::loop && arc.state == ArcState::accepted;
  }));
}

TEST(ThinnedGraph, HasTheSameOptimum) {
  const Graph& whole = twice_round().graph.graph();
  const std::vector<std::size_t> spare = every_second(whole);
  ThinnedGraph left = thinned(whole, steps_of(whole), spare);
  ASSERT_EQ(left.graph.poses().size(), whole.poses().size() - spare.size());
  EXPECT_GT(accepted_loops(left.graph), 3U);
  EXPECT_LE(accepted_loops(left.graph), accepted_loops(whole));
  GraphOptimizer().optimize(left.graph);
  auto next = whole.poses().begin();
  for (const GraphPose& pose : left.graph.poses()) {
    while (next->stamp < pose.stamp) ++next;
    const Pose moved = next->T_map_pose.inverse() * pose.T_map_pose;
    EXPECT_LT(moved.translation().norm(), 2e-3);
    EXPECT_LT(std::abs(yaw(moved)), 1e-3);
  }
}

TEST(ThinnedGraph, StepsAreThoseOverWhatWent) {
  const Graph& whole = twice_round().graph.graph();
  const std::vector<UncertainPose> steps = steps_of(whole);
  const std::vector<std::size_t> spare = every_second(whole);
  const ThinnedGraph left = thinned(whole, steps, spare);
  const std::vector<RestoredStep> told = restored_steps(left.graph);
  ASSERT_EQ(told.size(), left.steps.size());
  std::size_t was = 0;
  for (std::size_t i = 1; i < told.size(); ++i) {
    const std::size_t last = was++;
    if (std::binary_search(spare.begin(), spare.end(), was)) ++was;
    const UncertainPose expected = was == last + 1 ? steps[was] : steps[was - 1] * steps[was];
    EXPECT_TRUE(told[i].step.mean.isApprox(expected.mean, 1e-5));
    EXPECT_TRUE(told[i].step.covariance.isApprox(expected.covariance, 1e-4));
    const auto& keyframes = twice_round().graph.keyframes();
    const Pose T_odometry = keyframes[last].T_odom_base.inverse() * keyframes[was].T_odom_base;
    EXPECT_TRUE(told[i].T_odometry.isApprox(T_odometry, 1e-9));
  }
}

// What would have to move, seen in the map, for a loop to close.
Pose tear(const Arc& arc, const Graph& graph) {
  return graph.at(arc.from).T_map_pose * arc.T_from_to * graph.at(arc.to).T_map_pose.inverse();
}

TEST(ThinnedGraph, LoopsAreAsFarFromClosingAsTheyWere) {
  const Graph& whole = twice_round().graph.graph();
  const ThinnedGraph left = thinned(whole, steps_of(whole), every_second(whole));
  ASSERT_EQ(left.arcs.size(), left.graph.arcs().size());
  std::size_t carried = 0;
  for (std::size_t i = 0; i < left.arcs.size(); ++i) {
    const Arc& arc = left.graph.arcs()[i];
    const Arc& was = whole.arcs()[left.arcs[i]];
    if (arc.kind != ArcKind::loop) continue;
    EXPECT_EQ(arc.state, was.state);
    EXPECT_TRUE(tear(arc, left.graph).isApprox(tear(was, whole), 1e-9));
    const bool is_carried = left.graph.at(arc.from).stamp != whole.at(was.from).stamp;
    if (!is_carried) continue;
    EXPECT_LT(arc.information(5, 5), was.information(5, 5));
    ++carried;
  }
  EXPECT_GT(carried, 3U);
}

// Twelve keyframes in a row, and a gap before number 6.
struct Row {
  Row() {
    for (PoseId id = 0; id < 12; ++id) {
      graph.add(GraphPose{id, Time{seconds(static_cast<double>(id))},
                          planar_pose(static_cast<double>(id), 0.0, 0.0), id == 0});
      UncertainPose step{planar_pose(1.0, 0.0, 0.0), TangentMatrix::Zero()};
      step.covariance.diagonal() << 1e-4, 1e-4, 0.0, 0.0, 0.0, 1e-4;
      if (id == 6) step.covariance *= 1e5;
      steps.push_back(step);
      if (id > 0) arc(id - 1, id, ArcKind::odometry);
    }
  }

  void arc(PoseId from, PoseId to, ArcKind kind) {
    Arc made;
    made.from = from;
    made.to = to;
    made.T_from_to = planar_pose(static_cast<double>(to - from), 0.0, 0.0);
    made.kind = kind;
    graph.add(made);
  }

  std::size_t loops_without(std::size_t spare) const {
    return accepted_loops(thinned(graph, steps, {spare}).graph);
  }

  Graph graph;
  std::vector<UncertainPose> steps;
};

TEST(ThinnedGraph, LeavesOutLoopsWhereTheNeighbourHasOneFromTheSamePart) {
  Row row;
  row.arc(1, 9, ArcKind::loop);
  EXPECT_EQ(row.loops_without(1), 1U);
  EXPECT_EQ(row.loops_without(9), 1U);
  row.arc(6, 8, ArcKind::loop);  // which does not hold what is before the gap
  EXPECT_EQ(row.loops_without(9), 2U);
  row.arc(3, 8, ArcKind::loop);
  EXPECT_EQ(row.loops_without(9), 2U);
  EXPECT_EQ(row.loops_without(1), 3U);
}

}  // namespace
}  // namespace portolan
