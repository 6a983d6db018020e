// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/neighbour_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "graph/match/flat_world.hpp"
#include "portolan/graph/pose_graph.hpp"

namespace portolan {
namespace {

Keyframe keyframe(double second, const Pose& T_odom_base, const RangeScan& scan) {
  return {Time{seconds(second)}, T_odom_base, Pose::Identity(), scan, 0.0};
}

// A step of half a metre in the room within half a second, of which odometry says something else.
NeighbourArcs step_in_room(double odometry_way, const PoseGraphOptions& options) {
  std::mt19937_64 random(3);
  const Pose here = planar_pose(-0.5, -0.5, 0.3);
  const Pose there = here * planar_pose(0.5, 0.0, 0.0);
  const Keyframe last = keyframe(0.0, Pose::Identity(), room().scan(here, 360, 0.01, random));
  const Keyframe next =
      keyframe(0.5, planar_pose(odometry_way, 0.0, 0.0), room().scan(there, 360, 0.01, random));
  LocalMapMaker around(options.surfaces);
  around.add(last, Pose::Identity());
  return neighbour_arcs(last, next, std::move(around).make(), options);
}

PoseGraphOptions on_time() {
  PoseGraphOptions options;
  options.odometry.delay = 0.0;
  return options;
}

double deviation(const Arc& arc) { return 1.0 / std::sqrt(arc.information(0, 0)); }

TEST(NeighbourArcs, ScanAgreesWithGoodOdometry) {
  const NeighbourArcs arcs = step_in_room(0.49, on_time());
  ASSERT_TRUE(arcs.scan);
  EXPECT_EQ(arcs.scan->state, ArcState::accepted);
  EXPECT_EQ(arcs.scan->kind, ArcKind::scan);
  EXPECT_NEAR(arcs.scan->T_from_to.translation().x(), 0.5, 0.02);
  EXPECT_NEAR(deviation(arcs.odometry), 0.05 * std::sqrt(0.49), 1e-6);
}

TEST(NeighbourArcs, ScanThatFitsWellIsBelievedThoughOdometryContradicts) {
  const NeighbourArcs arcs = step_in_room(0.3, on_time());
  ASSERT_TRUE(arcs.scan);
  EXPECT_EQ(arcs.scan->state, ArcState::accepted);
  EXPECT_NEAR(arcs.scan->T_from_to.translation().x(), 0.5, 0.02);
}

TEST(NeighbourArcs, ContradictedOdometryIsTrustedLess) {
  const NeighbourArcs arcs = step_in_room(0.3, on_time());
  EXPECT_GT(deviation(arcs.odometry), 1.3 * 0.05 * std::sqrt(0.3));
}

TEST(NeighbourArcs, LateOdometryContradictsNothing) {
  PoseGraphOptions options;
  options.odometry.delay = 0.1;
  options.scans.sure_overlap = 1.1;
  const NeighbourArcs arcs = step_in_room(0.3, options);
  ASSERT_TRUE(arcs.scan);
  EXPECT_EQ(arcs.scan->state, ArcState::accepted);
  // 0.6 m/s for 0.1 s, at both ends.
  EXPECT_NEAR(deviation(arcs.odometry), std::sqrt(0.05 * 0.05 * 0.3 + 2.0 * 0.06 * 0.06), 1e-6);
}

TEST(NeighbourArcs, ScanIsNotBelievedAgainstOdometryWhereThatIsSwitchedOff) {
  PoseGraphOptions options = on_time();
  options.scans.sure_overlap = 1.1;
  const NeighbourArcs arcs = step_in_room(0.3, options);
  ASSERT_TRUE(arcs.scan);
  EXPECT_EQ(arcs.scan->state, ArcState::rejected);
  EXPECT_EQ(arcs.scan->reason, ArcReason::inconsistent);
}

TEST(NeighbourArcs, ScanIsNotBelievedAgainstOdometryThatIsFarMoreCertain) {
  PoseGraphOptions options = on_time();
  options.odometry.position = 0.005;
  const NeighbourArcs arcs = step_in_room(0.3, options);
  ASSERT_TRUE(arcs.scan);
  EXPECT_EQ(arcs.scan->reason, ArcReason::inconsistent);
}

TEST(NeighbourArcs, StampsThatStandStillDivideNothingByZero) {
  PoseGraphOptions options = on_time();
  const Keyframe here = keyframe(0.0, Pose::Identity(), {});
  const Keyframe there = keyframe(0.0, planar_pose(0.5, 0.0, 0.0), {});
  const NeighbourArcs arcs = neighbour_arcs(here, there, LocalMap{}, options);
  EXPECT_FALSE(arcs.scan);
  EXPECT_TRUE(arcs.odometry.information.allFinite());
}

// A laser on a clock of its own: stamps are right to some tens of milliseconds.
TEST(PoseGraph, IsNotTornByOdometryOfOtherMoments) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> late(0.0, 0.08);  // [s]
  const auto at = [](double time) { return planar_pose(-1.5 + 1.0 * time, -0.9, 0.8 * time); };
  PoseGraph graph(PoseGraph::Options{});
  std::vector<Pose> truth;
  for (double time = 0.0; time < 3.0; time += 0.25) {
    const RangeScan scan = room().scan(at(time), 360, 0.01, random);
    const Pose T_odom_base = at(time + late(random));
    if (graph.insert(Time{seconds(time)}, T_odom_base, scan, Pose::Identity()) ==
        Outcome::inserted) {
      truth.push_back(at(time));
    }
  }
  ASSERT_GT(truth.size(), 4U);
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const auto& poses = graph.graph().poses();
    const Pose step = poses[0].T_map_pose.inverse() * poses[i].T_map_pose;
    const Pose error = (truth[0].inverse() * truth[i]).inverse() * step;
    EXPECT_LT(error.translation().norm(), 0.04) << i;
  }
}

}  // namespace
}  // namespace portolan
