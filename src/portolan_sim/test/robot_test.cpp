// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

Robot::Options nimble() {
  Robot::Options options;
  options.max_speed = options.max_turn_rate = 10.0;
  options.max_acceleration = options.max_turn_acceleration = 1e9;
  return options;
}

void drive(Robot& robot, const Velocity& velocity, Duration duration, const World& world) {
  for (Duration t{0}; t < duration; t += 10ms) robot.advance(10ms, velocity, world);
}

TEST(Robot, DrivesStraight) {
  Robot robot(nimble(), planar_pose(1.0, 2.0, 0.3));
  drive(robot, {0.5, 0.0}, 4s, World({}));
  EXPECT_TRUE(robot.T_map_base().isApprox(
      planar_pose(1.0 + 2.0 * std::cos(0.3), 2.0 + 2.0 * std::sin(0.3), 0.3), 1e-9));
}

TEST(Robot, DrivesACircle) {
  Robot robot(nimble(), planar_pose(0.0, 0.0, 0.0));
  drive(robot, {0.5, 0.25}, 6s, World({}));
  const double turned = 1.5;
  const double radius = 2.0;
  EXPECT_TRUE(robot.T_map_base().isApprox(
      planar_pose(radius * std::sin(turned), radius * (1.0 - std::cos(turned)), turned), 1e-9));
}

TEST(Robot, TwoHalvesOfAnArcAreTheArc) {
  Random random(1, "arcs");
  for (int i = 0; i < 100; ++i) {
    const double turn = random.chance(0.2) ? 1e-10 : random.uniform(-3.0, 3.0);
    const Velocity velocity{random.uniform(-1.0, 1.0), turn};
    const Pose halves = driven(velocity, 0.5) * driven(velocity, 0.5);
    EXPECT_TRUE(halves.isApprox(driven(velocity, 1.0), 1e-9));
  }
}

TEST(Robot, KeepsItsLimits) {
  Robot::Options options;
  Robot robot(options, Pose::Identity());
  const World world({});
  Velocity before;
  for (int i = 0; i < 300; ++i) {
    robot.advance(10ms, {5.0, -9.0}, world);
    const Velocity now = robot.velocity();
    EXPECT_LE(now.forward - before.forward, options.max_acceleration * 0.01 + 1e-12);
    EXPECT_LE(before.turn - now.turn, options.max_turn_acceleration * 0.01 + 1e-12);
    before = now;
  }
  EXPECT_EQ(before.forward, options.max_speed);
  EXPECT_EQ(before.turn, -options.max_turn_rate);
}

TEST(Robot, StandsBeforeAWallAndComesAwayAgain) {
  const World world(room(4.0));
  Robot robot(Robot::Options{}, planar_pose(2.0, 2.0, 0.0));
  drive(robot, {0.5, 0.0}, 10s, world);
  EXPECT_TRUE(robot.blocked());
  EXPECT_NEAR(robot.T_map_base().translation().x(), 3.8, 0.01);
  EXPECT_LE(robot.T_map_base().translation().x(), 3.8);
  drive(robot, {-0.5, 0.0}, 2s, world);
  EXPECT_FALSE(robot.blocked());
  EXPECT_LT(robot.T_map_base().translation().x(), 3.2);
}

}  // namespace
}  // namespace portolan::sim
