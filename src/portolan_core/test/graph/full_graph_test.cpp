// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graph/round_drive.hpp"
#include "portolan/graph/pose_graph_file.hpp"

namespace portolan {
namespace {

constexpr double kWay = 500.0;  // [m]
constexpr std::size_t kMaxCount = 250;

PoseGraph::Options of_count(std::size_t count) {
  PoseGraph::Options options;
  options.keyframes.max_count = static_cast<int>(count);
  options.loops.enough = 5;
  return options;
}

Drive driven(std::size_t max_count) {
  Drive run;
  drive(run, 0.0, kWay, of_count(max_count));
  return run;
}

const Drive& full() {
  static const Drive kRun = driven(kMaxCount);
  return kRun;
}

const Drive& unlimited() {
  static const Drive kRun = driven(10000);
  return kRun;
}

Pose truth_of(const GraphPose& pose) {
  return on_the_round(to_seconds(pose.stamp.time_since_epoch()) - 10.0);
}

// Of where a graph puts its keyframes, seen from the first one [m].
double rmse(const PoseGraph& graph) {
  const auto& poses = graph.graph().poses();
  const Pose T_map_world = poses.front().T_map_pose * truth_of(poses.front()).inverse();
  double sum = 0.0;
  for (const GraphPose& pose : poses) {
    const Pose truth = T_map_world * truth_of(pose);
    sum += (truth.translation() - pose.T_map_pose.translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

TEST(FullGraph, GoesOnWithFewerKeyframes) {
  EXPECT_GT(full().graph.dropped(), 2 * kMaxCount);
  EXPECT_LE(full().graph.keyframes().size(), kMaxCount);
  EXPECT_GT(full().graph.keyframes().size(), kMaxCount / 2);
  EXPECT_EQ(full().truth.size(), unlimited().truth.size());
  EXPECT_EQ(full().graph.keyframes().size() + full().graph.dropped(),
            unlimited().graph.keyframes().size());
}

TEST(FullGraph, KnowsTheWayAsWell) {
  EXPECT_LT(rmse(full().graph), rmse(unlimited().graph) + 0.03);
  const Correction fewer = full().graph.correction();
  const Correction all = unlimited().graph.correction();
  double sum = 0.0;
  for (const Keyframe& keyframe : unlimited().graph.keyframes()) {
    const Pose here = fewer.at(keyframe.stamp) * keyframe.T_odom_base;
    const Pose there = all.at(keyframe.stamp) * keyframe.T_odom_base;
    sum += (here.translation() - there.translation()).squaredNorm();
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(all.knots().size())), 0.1);
}

TEST(FullGraph, StillClosesLoops) {
  const PoseGraph& graph = full().graph;
  const double recently = graph.keyframes().back().travelled - 100.0;
  const auto& arcs = graph.graph().arcs();
  EXPECT_TRUE(std::any_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    return arc.kind == ArcKind::loop && arc.state == ArcState::accepted &&
           graph.keyframes()[index_of(arc.to)].travelled > recently;
  }));
}

TEST(FullGraph, IsTheSameEveryTime) {
  const Correction again = driven(kMaxCount).graph.correction();
  const Correction first = full().graph.correction();
  ASSERT_EQ(again.knots().size(), first.knots().size());
  for (std::size_t i = 0; i < first.knots().size(); ++i) {
    EXPECT_EQ(again.knots()[i].stamp, first.knots()[i].stamp);
    EXPECT_EQ(again.knots()[i].T_map_odom.matrix(), first.knots()[i].T_map_odom.matrix());
  }
}

TEST(FullGraph, GoesOnAfterItWasSaved) {
  Drive run = full();
  const FileSet files = pose_graph_files(run.graph, "graph");
  run.graph = pose_graph_from(of_count(kMaxCount), files, "graph");
  EXPECT_EQ(pose_graph_files(run.graph, "graph").at("graph.scans"), files.at("graph.scans"));
  ASSERT_EQ(run.graph.keyframes().size(), full().graph.keyframes().size());
  const Correction before = full().graph.correction();
  const Correction after = run.graph.correction();
  for (std::size_t i = 0; i < before.knots().size(); ++i) {
    EXPECT_TRUE(after.knots()[i].T_map_odom.isApprox(before.knots()[i].T_map_odom, 1e-3));
  }
  go_on(run, kWay, kWay + 120.0);
  EXPECT_FALSE(run.graph.is_lost());
  EXPECT_GT(run.graph.dropped(), 0U);
  EXPECT_LT(rmse(run.graph), rmse(full().graph) + 0.03);
}

TEST(FullGraph, RejectsWhatComesWhereNothingCanGo) {
  Drive run;
  drive(run, 0.0, 60.0, of_count(40));
  EXPECT_EQ(run.graph.keyframes().size(), 40U);
  EXPECT_EQ(run.graph.dropped(), 0U);
  EXPECT_EQ(run.truth.size(), 40U);
}

TEST(FullGraph, GoesOnWithoutTheOldestScans) {
  PoseGraph::Options options = of_count(kMaxCount);
  options.keyframes.scan_budget = 0.1;
  Drive run;
  drive(run, 0.0, kWay, options);
  EXPECT_GT(run.graph.forgotten(), 50U);
  EXPECT_LT(run.graph.forgotten(), run.graph.keyframes().size());
  EXPECT_GT(run.graph.dropped(), kMaxCount);
  EXPECT_LT(rmse(run.graph), 0.1);
}

// Somebody carries the robot, and the graph is full before it is found, and often after.
TEST(FullGraph, StillFindsARobotThatWasCarried) {
  Drive run = full();
  run.graph = pose_graph_from(of_count(kMaxCount), pose_graph_files(run.graph, "graph"), "graph");
  run.T_odom = Pose::Identity();
  go_on(run, kWay + 24.0, kWay + 24.2);
  EXPECT_TRUE(run.graph.is_lost());
  go_on(run, kWay + 24.3, kWay + 44.0);
  EXPECT_FALSE(run.graph.is_lost());
  go_on(run, kWay + 44.1, kWay + 250.0);
  EXPECT_FALSE(run.graph.is_lost());
  EXPECT_GT(run.graph.dropped(), kMaxCount);
}

}  // namespace
}  // namespace portolan
