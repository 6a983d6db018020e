// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

constexpr double kFar = 100.0;

TEST(World, AWallClosesItsCorners) {
  const World world(room(2.0));
  const Ray to_corner{{1.0, 1.0, 0.5}, Eigen::Vector3d(1, 1, 0).normalized()};
  EXPECT_NEAR(world.cast(to_corner, Wave::light, kFar)->range, std::sqrt(2.0), 1e-9);
}

TEST(World, LightPassesGlassAndSoundDoesNot) {
  WorldOptions options = room(4.0);
  WorldOptions::Wall pane;
  pane.points = {{2.0, 0.0}, {2.0, 4.0}};
  pane.material = Material::glass;
  options.walls.push_back(pane);
  const World world(options);
  const Ray ray{{1.0, 2.0, 0.5}, Eigen::Vector3d::UnitX()};
  EXPECT_NEAR(world.cast(ray, Wave::light, kFar)->range, 3.0, 1e-9);
  EXPECT_NEAR(world.cast(ray, Wave::sound, kFar)->range, 0.95, 1e-9);
  EXPECT_TRUE(world.sees({1, 2, 0.5}, {3, 2, 0.5}));
}

TEST(World, FloorAndCeilingAreMetFromWithin) {
  WorldOptions options;
  options.ceiling = 2.0;
  const World world(options);
  EXPECT_NEAR(world.cast({{0, 0, 0.5}, -Eigen::Vector3d::UnitZ()}, Wave::light, kFar)->range, 0.5,
              1e-12);
  EXPECT_NEAR(world.cast({{0, 0, 0.5}, Eigen::Vector3d::UnitZ()}, Wave::light, kFar)->range, 1.5,
              1e-12);
  EXPECT_FALSE(world.cast({{0, 0, 0.5}, Eigen::Vector3d::UnitX()}, Wave::light, kFar));
  EXPECT_FALSE(world.cast({{0, 0, 0.5}, Eigen::Vector3d::UnitZ()}, Wave::light, 1.0));
}

TEST(World, WhatHangsIsPassedBelow) {
  WorldOptions options;
  WorldOptions::Box shelf;
  shelf.center = {2.0, 0.0};
  shelf.bottom = 0.7;
  shelf.height = 0.05;
  options.boxes.push_back(shelf);
  const World world(options);
  EXPECT_FALSE(world.cast({{0, 0, 0.2}, Eigen::Vector3d::UnitX()}, Wave::light, kFar));
  EXPECT_TRUE(world.cast({{0, 0, 0.72}, Eigen::Vector3d::UnitX()}, Wave::light, kFar));
  EXPECT_EQ(world.clearance({2.0, 0.0}, 1.0, 0.0, 0.4), 1.0);
  EXPECT_EQ(world.clearance({2.0, 0.0}, 1.0, 0.0, 1.4), 0.0);
}

TEST(World, TwoMarksOfAKindMayNotShareAnIdentity) {
  WorldOptions options;
  options.landmarks.resize(2);
  options.landmarks[0].id = options.landmarks[1].id = 7;
  try {
    World world(options);
    FAIL() << "two landmarks with one id were taken";
  } catch (const OptionsError& error) {
    EXPECT_NE(std::string(error.what()).find("7"), std::string::npos);
  }
}

TEST(World, EveryFaultIsNamedAtOnce) {
  WorldOptions options;
  options.walls.resize(1);
  options.boxes.resize(1);
  options.boxes[0].size = {1.0};
  EXPECT_EQ(faults(options).size(), 2U);
  EXPECT_THROW(World{options}, OptionsError);
}

}  // namespace
}  // namespace portolan::sim
