// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "graph/round_drive.hpp"
#include "portolan/graph/pose_graph_file.hpp"

namespace portolan {
namespace {

constexpr double kRound = 44.0;  // [m]

const Drive& round_and_on() {
  static const Drive kRun = [] {
    Drive made;
    drive(made, 0.0, kRound + 16.0);
    return made;
  }();
  return kRun;
}

// The robot is switched off, carried to another point of its round, and its wheels begin anew.
Drive carried() {
  Drive run = round_and_on();
  run.graph = pose_graph_from({}, pose_graph_files(run.graph, "graph"), "graph");
  run.T_odom = Pose::Identity();
  return run;
}

// Of where the graph puts the newest keyframe, seen from the first one [m].
double error_now(const Drive& run) {
  const auto& poses = run.graph.graph().poses();
  const Pose estimate = poses.front().T_map_pose.inverse() * poses.back().T_map_pose;
  const Pose truth = run.truth.front().inverse() * run.truth.back();
  return (truth.inverse() * estimate).translation().norm();
}

// Where the robot is by then, as somebody in the map would say it, wrong by so much.
UncertainPose told(const Drive& run, double way, const Pose& error) {
  UncertainPose T_map_base;
  T_map_base.mean = run.graph.graph().poses().front().T_map_pose * run.truth.front().inverse() *
                    on_the_round(way) * error;
  T_map_base.covariance.diagonal() << 0.25, 0.25, 0.0, 0.0, 0.0, 0.07;
  return T_map_base;
}

TEST(LostRobot, IsFoundInTheWholeGraph) {
  for (const double way : {2.0, 24.0, 38.0}) {
    Drive run = carried();
    EXPECT_FALSE(run.graph.is_lost());
    go_on(run, 2.0 * kRound + way, 2.0 * kRound + way + 0.2);
    EXPECT_TRUE(run.graph.is_lost());
    go_on(run, 2.0 * kRound + way + 0.3, 2.0 * kRound + way + 18.0);
    EXPECT_FALSE(run.graph.is_lost()) << way;
    EXPECT_LT(error_now(run), 0.1) << way;
  }
}

TEST(LostRobot, IsWhereSomebodySaysAtOnce) {
  Drive run = carried();
  const double way = 2.0 * kRound + 24.0;
  const UncertainPose guess = told(run, way, planar_pose(0.4, -0.3, 0.15));
  EXPECT_EQ(run.graph.expect(guess), Outcome::inserted);
  go_on(run, way, way + 0.05);
  EXPECT_NEAR(error_now(run), 0.5, 0.05);
  EXPECT_TRUE(run.graph.is_lost());
  go_on(run, way + 0.1, way + 8.0);
  EXPECT_FALSE(run.graph.is_lost());
  EXPECT_LT(error_now(run), 0.1);
}

// In mid-run, without a file: the robot is lifted, and odometry does not notice.
TEST(LostRobot, StartsAnewFromWhereItWasPutDown) {
  Drive run = round_and_on();
  const double way = 2.0 * kRound + 34.0;
  EXPECT_EQ(run.graph.expect(told(run, way, planar_pose(-0.3, 0.3, -0.1))), Outcome::inserted);
  go_on(run, way, way + 8.0);
  EXPECT_FALSE(run.graph.is_lost());
  EXPECT_LT(error_now(run), 0.1);
}

TEST(LostRobot, WhatWasSaidCountsFromItsTimeOn) {
  Drive run = round_and_on();
  const std::size_t before = run.graph.keyframes().size();
  const double way = kRound + 16.3;
  const Time later{seconds(10.0 + way + 0.2)};
  EXPECT_EQ(run.graph.expect(told(run, way, Pose::Identity()), later), Outcome::inserted);
  go_on(run, way - 0.1, way + 0.1);
  EXPECT_EQ(run.graph.keyframes().size(), before);
  go_on(run, way + 0.2, way + 0.25);
  EXPECT_EQ(run.graph.keyframes().size(), before + 1);
}

TEST(LostRobot, AGuessThatIsTakenOutLeavesNoTrace) {
  Drive run = carried();
  go_on(run, 2.0 * kRound + 24.0, 2.0 * kRound + 24.05);
  Drive guessed = carried();
  guessed.graph.expect(told(guessed, 2.0 * kRound + 6.0, Pose::Identity()));
  go_on(guessed, 2.0 * kRound + 24.0, 2.0 * kRound + 24.05);
  const auto& arcs = guessed.graph.graph().arcs();
  const auto is_guess = [](const Arc& arc) { return arc.kind == ArcKind::given; };
  const auto guess = std::find_if(arcs.begin(), arcs.end(), is_guess);
  ASSERT_NE(guess, arcs.end());
  guessed.graph.disable(static_cast<std::size_t>(guess - arcs.begin()));
  const Correction before = round_and_on().graph.correction();
  const Correction after = guessed.graph.correction();
  for (std::size_t i = 0; i < before.knots().size(); ++i) {
    EXPECT_TRUE(after.knots()[i].T_map_odom.isApprox(before.knots()[i].T_map_odom, 1e-6));
  }
}

TEST(LostRobot, RefusesWhatMakesNoSense) {
  PoseGraph empty(PoseGraph::Options{});
  const UncertainPose good = told(round_and_on(), 0.0, Pose::Identity());
  EXPECT_EQ(empty.expect(good), Outcome::rejected);
  PoseGraph graph = round_and_on().graph;
  UncertainPose bad = good;
  bad.covariance(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(graph.expect(bad), Outcome::unusable);
  bad.covariance(0, 0) = -1.0;
  EXPECT_EQ(graph.expect(bad), Outcome::unusable);
  bad = good;
  bad.mean.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(graph.expect(bad), Outcome::unusable);
}

// Rooms that are all alike along a corridor.
FlatWorld alike(int rooms) {
  FlatWorld world;
  world.wall(-1.0, -1.0, 4.0 * rooms + 1.0, -1.0).wall(-1.0, 1.0, 0.0, 1.0);
  world.wall(-1.0, -1.0, -1.0, 1.0).wall(4.0 * rooms + 1.0, -1.0, 4.0 * rooms + 1.0, 1.0);
  world.wall(4.0 * rooms, 1.0, 4.0 * rooms + 1.0, 1.0).wall(0.0, 5.0, 4.0 * rooms, 5.0);
  for (int i = 0; i < rooms; ++i) {
    const double x = 4.0 * i;
    world.wall(x, 1.0, x + 1.4, 1.0).wall(x + 2.6, 1.0, x + 4.0, 1.0).wall(x, 1.0, x, 5.0);
    world.box(x + 0.2, 4.0, x + 1.0, 4.8).box(x + 3.2, 2.0, x + 3.8, 2.6);
  }
  return world.wall(4.0 * rooms, 1.0, 4.0 * rooms, 5.0);
}

// From the corridor into each of these rooms and out again; steps of a decimetre.
std::vector<Pose> visits(int from, int to) {
  std::vector<Pose> way;
  for (int i = from; i < to; ++i) {
    const double x = 4.0 * i + 2.0;
    for (double s = -2.0; s < 0.0; s += 0.1) way.push_back(planar_pose(x + s, 0.0, 0.0));
    for (double s = 0.0; s < 3.0; s += 0.1) way.push_back(planar_pose(x, s, M_PI_2));
    for (double s = 3.0; s > 0.0; s -= 0.1) way.push_back(planar_pose(x, s, M_PI_2));
    for (double s = 0.0; s < 2.0; s += 0.1) way.push_back(planar_pose(x + s, 0.0, 0.0));
  }
  return way;
}

TEST(LostRobot, IsNotFoundInRoomsThatAreAllAlike) {
  const FlatWorld world = alike(7);
  std::mt19937_64 random(2);
  PoseGraph graph(PoseGraph::Options{});
  double time = 0.0;
  const auto follow = [&](const std::vector<Pose>& way, const Pose& T_odom_map) {
    for (const Pose& T : way) {
      time += 0.2;
      graph.insert(Time{seconds(time)}, T_odom_map * T, world.scan(T, 180, 0.01, random),
                   Pose::Identity());
    }
  };
  follow(visits(0, 7), Pose::Identity());
  graph = pose_graph_from({}, pose_graph_files(graph, "graph"), "graph");
  follow(visits(3, 5), planar_pose(100.0, 50.0, 1.0));
  EXPECT_TRUE(graph.is_lost());
}

}  // namespace
}  // namespace portolan
