// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/pose_graph.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "graph/round_drive.hpp"

namespace portolan {
namespace {

// Of where the graph puts the last keyframe, seen from the first one [m].
double end_error(const Drive& run) {
  const auto& poses = run.graph.graph().poses();
  const Pose estimate = poses.front().T_map_pose.inverse() * poses.back().T_map_pose;
  const Pose truth = run.truth.front().inverse() * run.truth.back();
  return (truth.inverse() * estimate).translation().norm();
}

const Drive& twice_round() {
  static const Drive kRun = [] {
    Drive made;
    drive(made, 0.0, 80.0, odometry_only());
    return made;
  }();
  return kRun;
}

bool same_bytes(const Correction& a, const Correction& b) {
  if (a.knots().size() != b.knots().size()) return false;
  for (std::size_t i = 0; i < a.knots().size(); ++i) {
    if (a.knots()[i].T_map_odom.matrix() != b.knots()[i].T_map_odom.matrix()) return false;
  }
  return true;
}

TEST(PoseGraph, MatchesNeighboursBetterThanOdometry) {
  PoseGraph::Options options;
  options.loops.enabled = false;
  Drive matched;
  drive(matched, 0.0, 40.0, options);
  options.scans.enabled = false;
  Drive counted;
  drive(counted, 0.0, 40.0, options);
  EXPECT_EQ(count(matched.graph, ArcKind::loop, ArcState::accepted), 0U);
  EXPECT_EQ(count(counted.graph, ArcKind::scan, ArcState::accepted), 0U);
  EXPECT_GT(end_error(counted), 1.0);
  EXPECT_LT(end_error(matched), 0.5);
}

TEST(PoseGraph, ClosesTheLoopAndBends) {
  const Drive& run = twice_round();
  EXPECT_GT(count(run.graph, ArcKind::loop, ArcState::accepted), 3U);
  EXPECT_LT(end_error(run), 0.2);
  for (const Arc& arc : run.graph.graph().arcs()) {
    if (arc.kind != ArcKind::loop || arc.state != ArcState::accepted) continue;
    const auto at = [&](PoseId id) { return run.truth[static_cast<std::size_t>(id)]; };
    const Pose error = arc.T_from_to.inverse() * (at(arc.from).inverse() * at(arc.to));
    EXPECT_LT(error.translation().norm(), 0.1) << arc.from << " -> " << arc.to;
    EXPECT_LT(std::abs(yaw(error)), 0.1);
  }
}

TEST(PoseGraph, CorrectionPutsOdometryWhereTheKeyframesAre) {
  const PoseGraph& graph = twice_round().graph;
  const Correction correction = graph.correction();
  ASSERT_EQ(correction.knots().size(), graph.keyframes().size());
  for (std::size_t i = 0; i < graph.keyframes().size(); ++i) {
    const Keyframe& keyframe = graph.keyframes()[i];
    const Pose T_map_base = correction.at(keyframe.stamp) * keyframe.T_odom_base;
    EXPECT_TRUE(T_map_base.isApprox(graph.graph().poses()[i].T_map_pose, 1e-9));
  }
  EXPECT_TRUE(correction.knots().front().T_map_odom.isApprox(Pose::Identity(), 1e-9));
}

TEST(PoseGraph, IsTheSameEveryTime) {
  Drive again;
  drive(again, 0.0, 80.0, odometry_only());
  EXPECT_TRUE(same_bytes(again.graph.correction(), twice_round().graph.correction()));
}

TEST(PoseGraph, AFalseArcIsRefused) {
  PoseGraph graph = Drive(twice_round()).graph;
  const Correction before = graph.correction();
  const TangentMatrix sure = 1e4 * TangentMatrix::Identity();
  const std::size_t arc = graph.add(3, 60, Pose::Identity(), sure, false);
  EXPECT_EQ(graph.graph().arcs()[arc].state, ArcState::rejected);
  EXPECT_NE(graph.graph().arcs()[arc].reason, ArcReason::none);
  EXPECT_TRUE(same_bytes(graph.correction(), before));
}

TEST(PoseGraph, AFalseArcForcedInAndDisabledLeavesNoTrace) {
  PoseGraph graph = Drive(twice_round()).graph;
  const Correction before = graph.correction();
  const TangentMatrix sure = 1e4 * TangentMatrix::Identity();
  const std::size_t arc = graph.add(3, 60, Pose::Identity(), sure, true);
  EXPECT_EQ(graph.graph().arcs()[arc].state, ArcState::accepted);
  EXPECT_FALSE(same_bytes(graph.correction(), before));
  graph.disable(arc);
  EXPECT_TRUE(same_bytes(graph.correction(), before));
  graph.enable(arc);
  EXPECT_FALSE(same_bytes(graph.correction(), before));
}

TEST(PoseGraph, WithoutItsLoopsItIsOdometryAgain) {
  PoseGraph graph = Drive(twice_round()).graph;
  for (std::size_t i = 0; i < graph.graph().arcs().size(); ++i) {
    if (graph.graph().arcs()[i].kind == ArcKind::loop) graph.disable(i);
  }
  for (std::size_t i = 0; i < graph.keyframes().size(); ++i) {
    const Pose& T_odom_base = graph.keyframes()[i].T_odom_base;
    EXPECT_TRUE(graph.graph().poses()[i].T_map_pose.isApprox(T_odom_base, 1e-9));
  }
  EXPECT_THROW(graph.disable(0), std::invalid_argument);
  EXPECT_THROW(graph.enable(100000), std::out_of_range);
}

TEST(PoseGraph, ATrueArcIsAccepted) {
  const Drive& run = twice_round();
  PoseGraph graph = run.graph;
  const Pose T = run.truth[4].inverse() * run.truth[5 + 44 * 2];
  const TangentMatrix sure = 400.0 * TangentMatrix::Identity();
  const std::size_t arc = graph.add(4, 93, T, sure, false);
  EXPECT_EQ(graph.graph().arcs()[arc].state, ArcState::accepted)
      << enum_names(ArcReason{})[static_cast<std::size_t>(graph.graph().arcs()[arc].reason)];
}

TEST(PoseGraph, DoesNotGrowWhileTheRobotStands) {
  std::mt19937_64 random(1);
  PoseGraph::Options options;
  options.keyframes.min_interval = 1.0;
  PoseGraph graph(options);
  const RangeScan scan = office().scan(planar_pose(1, 1, 0), 180, 0.01, random);
  for (int i = 0; i < 3600; ++i) {
    const double jitter = i % 2 == 0 ? 1e-3 : 0.0;
    graph.insert(Time{seconds(i)}, planar_pose(jitter, 0, 0), scan, Pose::Identity());
  }
  EXPECT_EQ(graph.keyframes().size(), 1U);
}

TEST(PoseGraph, LooksForNoMoreLoopsWhereItKnowsEnough) {
  const auto rounds = [](double min_doubt) {
    PoseGraph::Options options;
    options.loops.enough = 5;
    options.loops.min_doubt = min_doubt;
    Drive run;
    drive(run, 0.0, 150.0, options);
    return run;
  };
  const Drive sparing = rounds(PoseGraph::Options{}.loops.min_doubt);
  const Drive tireless = rounds(0.0);
  const auto loops = [](const Drive& run) {
    return count(run.graph, ArcKind::loop, ArcState::accepted);
  };
  EXPECT_GT(loops(sparing), 3U);
  EXPECT_LT(3 * loops(sparing), 2 * loops(tireless));
  EXPECT_LT(end_error(sparing), 0.2);
}

TEST(PoseGraph, RefusesWhatMakesNoSense) {
  std::mt19937_64 random(1);
  PoseGraph graph(PoseGraph::Options{});
  const RangeScan scan = office().scan(planar_pose(1, 1, 0), 180, 0.01, random);
  const Pose here = Pose::Identity();
  Pose nan = here;
  nan.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(graph.insert(Time{}, nan, scan, here), Outcome::unusable);
  EXPECT_EQ(graph.insert(Time{}, here, scan, nan), Outcome::unusable);
  EXPECT_EQ(graph.insert(Time{}, here, RangeScan{}, here), Outcome::unusable);
  EXPECT_EQ(graph.insert(Time{seconds(5)}, here, scan, here), Outcome::inserted);
  EXPECT_EQ(graph.insert(Time{seconds(5)}, planar_pose(1, 0, 0), scan, here), Outcome::rejected);
  EXPECT_EQ(graph.insert(Time{seconds(4)}, planar_pose(1, 0, 0), scan, here), Outcome::rejected);
  EXPECT_EQ(graph.insert(Time{seconds(6)}, planar_pose(0.1, 0, 0), scan, here), std::nullopt);
  EXPECT_EQ(graph.keyframes().size(), 1U);
}

TEST(PoseGraph, GoesOnWithoutEchoes) {
  std::mt19937_64 random(1);
  PoseGraph graph(PoseGraph::Options{});
  const RangeScan empty = FlatWorld{}.scan(Pose::Identity(), 180, 0.0, random);
  for (int i = 0; i < 50; ++i) {
    const Outcome expected = Outcome::inserted;
    EXPECT_EQ(graph.insert(Time{seconds(i)}, planar_pose(i, 0, 0), empty, Pose::Identity()),
              expected);
  }
  EXPECT_EQ(count(graph, ArcKind::odometry, ArcState::accepted), 49U);
  EXPECT_EQ(graph.graph().arcs().size(), 49U);
}

TEST(PoseGraph, ScansBridgeAJumpOfTheOdometry) {
  const FlatWorld world = office();
  std::mt19937_64 random(1);
  PoseGraph graph(PoseGraph::Options{});
  Pose jump = Pose::Identity();
  for (double way = 0.0; way < 13.0; way += 0.25) {
    if (way == 6.0) jump = planar_pose(30.0, -20.0, 1.0);
    const Pose truth = on_the_round(way);
    graph.insert(Time{seconds(way)}, jump * truth, world.scan(truth, 180, 0.01, random),
                 Pose::Identity());
  }
  const auto weak = [](const Arc& arc) {
    return arc.kind == ArcKind::odometry && arc.information(0, 0) < 0.01;
  };
  const auto& arcs = graph.graph().arcs();
  EXPECT_EQ(std::count_if(arcs.begin(), arcs.end(), weak), 1);
}

TEST(PoseGraph, ForgetsTheOldestScansPastItsBudget) {
  PoseGraph::Options options = odometry_only();
  options.keyframes.scan_budget = 0.02;
  Drive run;
  drive(run, 0.0, 80.0, options);
  EXPECT_GT(run.graph.forgotten(), 100U);
  EXPECT_TRUE(run.graph.keyframes().front().scan.ranges.empty());
  EXPECT_FALSE(run.graph.keyframes().back().scan.ranges.empty());
  EXPECT_EQ(count(run.graph, ArcKind::loop, ArcState::accepted), 0U);
}

TEST(PoseGraph, GoesOnFromASavedGraph) {
  const PoseGraph& graph = twice_round().graph;
  const PoseGraph again = PoseGraph::restored(odometry_only(), graph.graph());
  ASSERT_EQ(again.keyframes().size(), graph.keyframes().size());
  for (std::size_t i = 0; i < graph.keyframes().size(); ++i) {
    const Pose& T_map_base = graph.graph().poses()[i].T_map_pose;
    EXPECT_TRUE(again.graph().poses()[i].T_map_pose.isApprox(T_map_base, 1e-6));
    const Pose& T_odom_base = graph.keyframes()[i].T_odom_base;
    EXPECT_TRUE(again.keyframes()[i].T_odom_base.isApprox(T_odom_base, 1e-9));
  }
  Graph torn(GraphSpace::planar);
  torn.add(GraphPose{0, Time{seconds(1)}});
  torn.add(GraphPose{1, Time{seconds(2)}});
  EXPECT_THROW(PoseGraph::restored({}, torn), std::invalid_argument);
}

}  // namespace
}  // namespace portolan
