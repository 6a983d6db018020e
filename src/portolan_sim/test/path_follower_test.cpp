// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/path_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "portolan/sim/robot.hpp"

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

struct Trip {
  bool finished = false;
  double furthest_aside = 0.0;  // of the straight lines [m]
  double turned = 0.0;          // in all, counter-clockwise counted positive [rad]
  Eigen::Vector2d end;
};

double distance_to_line(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& line) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    const double at = std::clamp((p - line[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - line[i - 1] - at * way).norm());
  }
  return nearest;
}

Trip follow(const PathFollower::Options& options, const std::vector<Eigen::Vector2d>& points) {
  PathFollower follower(options, points);
  Robot robot(Robot::Options{}, planar_pose(points[0].x(), points[0].y(), 2.0));
  const World world({});
  Trip trip;
  for (Duration t{0}; t < 300s && !trip.finished; t += 10ms) {
    robot.advance(10ms, follower.steer(robot.T_map_base(), 0.01), world);
    trip.end = robot.T_map_base().translation().head<2>();
    trip.furthest_aside = std::max(trip.furthest_aside, distance_to_line(trip.end, points));
    trip.turned += robot.velocity().turn * 0.01;
    trip.finished = follower.finished();
  }
  return trip;
}

TEST(PathFollower, KeepsToTheLineAndArrives) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {4, 0}, {4, 3}, {1, 1}, {1, -2}, {1.2, 2}};
  const Trip trip = follow({}, points);
  EXPECT_TRUE(trip.finished);
  EXPECT_LT(trip.furthest_aside, 0.1);
  EXPECT_LT((trip.end - points.back()).norm(), 0.06);
}

TEST(PathFollower, SpinsAtPointsWhereAsked) {
  PathFollower::Options options;
  options.spin_at_points = 2.0 * M_PI;
  const Trip trip = follow(options, {{0, 0}, {1, 0}});
  EXPECT_TRUE(trip.finished);
  EXPECT_NEAR(trip.turned, -2.0 + 4.0 * M_PI, 0.35);
}

TEST(PathFollower, StandsWithoutAPath) {
  PathFollower follower({}, {});
  EXPECT_TRUE(follower.finished());
  const Velocity velocity = follower.steer(Pose::Identity(), 0.01);
  EXPECT_EQ(velocity.forward, 0.0);
  EXPECT_EQ(velocity.turn, 0.0);
}

}  // namespace
}  // namespace portolan::sim
