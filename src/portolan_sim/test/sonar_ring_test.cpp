// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/sonar_ring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One sonar at the middle of the base, looking ahead, that neither errs nor misses.
SonarRing::Options exact() {
  SonarRing::Options options;
  options.angles = {0.0};
  options.radius = 0.0;
  options.specular_angle = 3.0;
  options.noise.range_stddev = 0.0;
  return options;
}

double range_of(const SonarRing::Options& options, const World& world, const Pose& T_map_base) {
  SonarRing ring(options, 1);
  return ring.sense(0, world, T_map_base).range;
}

WorldOptions without_floor(WorldOptions world) {
  world.floor = false;
  return world;
}

TEST(SonarRing, HearsTheNearestSurfaceInTheCone) {
  Random random(1, "sonar");
  SonarRing ring(exact(), 1);
  int heard = 0;
  for (int i = 0; i < 200; ++i) {
    const World world(clutter(4, 3.0, random));
    const Pose T_map_base = planar_pose(random.uniform(-3, 3), random.uniform(-3, 3), i);
    const Pose T_map_sonar = T_map_base * ring.mount(0);
    double nearest = kInfinity;
    for (const Eigen::Vector3d& direction : ring.cone()) {
      const Ray ray{T_map_sonar.translation(), T_map_sonar.linear() * direction};
      const auto hit = world.cast(ray, Wave::sound, ring.options().noise.range_max);
      if (hit && returns(Wave::sound, hit->material)) nearest = std::min(nearest, hit->range);
    }
    EXPECT_EQ(ring.nearest(0, world, T_map_base), nearest);
    heard += std::isfinite(nearest) ? 1 : 0;
  }
  EXPECT_GT(heard, 50);
}

TEST(SonarRing, TheConeIsAsWideAsItsApertureAllRound) {
  const SonarRing ring(exact(), 1);
  double widest = 0.0;
  double highest = 0.0;
  for (const Eigen::Vector3d& ray : ring.cone()) {
    EXPECT_NEAR(ray.norm(), 1.0, 1e-12);
    widest = std::max(widest, std::atan2(ray.y(), ray.x()));
    highest = std::max(highest, std::asin(ray.z()));
    EXPECT_LE(std::acos(ray.x()), 0.22 + 0.001);
  }
  EXPECT_NEAR(widest, 0.22, 1e-9);
  EXPECT_NEAR(highest, 0.22, 1e-9);
}

TEST(SonarRing, HearsAWallAtTheSideOfTheConeNearerThanAhead) {
  const World world(without_floor(room(4.0)));
  const double ahead = 1.0;
  const double turned = 0.3;
  const double expected = ahead / std::cos(turned - 0.22);
  EXPECT_NEAR(range_of(exact(), world, planar_pose(3.0, 2.0, turned)), expected, 1e-9);
}

TEST(SonarRing, ASurfaceMetTooFarFromItsNormalIsNotHeard) {
  const World world(without_floor(room(4.0)));
  SonarRing::Options options = exact();
  options.noise.range_max = 2.0;
  options.specular_angle = 0.5;
  const Pose slanted_in = planar_pose(3.0, 2.0, 0.5 + 0.22 - 0.01);
  const Pose slanted_out = planar_pose(3.0, 2.0, 0.5 + 0.22 + 0.01);
  EXPECT_NEAR(range_of(options, world, slanted_in), 1.0 / std::cos(0.49), 1e-9);
  EXPECT_EQ(range_of(options, world, slanted_out), kInfinity);
}

TEST(SonarRing, HearsGlassAndNothingSoft) {
  const Pose pose = planar_pose(2.0, 2.0, 0.0);
  EXPECT_NEAR(range_of(exact(), World(without_floor(room(4.0, Material::glass))), pose), 2.0, 1e-9);
  EXPECT_EQ(range_of(exact(), World(without_floor(room(4.0, Material::soft))), pose), kInfinity);
}

TEST(SonarRing, SonarsStandOnTheCircleLookingOutwards) {
  SonarRing::Options options;
  options.position = {0.1, 0.0, 0.3};
  const SonarRing ring(options, 1);
  ASSERT_EQ(ring.size(), 8U);
  EXPECT_EQ(ring.frame(7), "sonar_7");
  const Eigen::Vector3d leftmost = ring.mount(7).translation();
  EXPECT_TRUE(leftmost.isApprox(Eigen::Vector3d(0.1, 0.2, 0.3), 1e-4));
  EXPECT_NEAR(yaw(ring.mount(7)), 1.5708, 1e-9);
}

TEST(SonarRing, CrosstalkHearsANearerEchoOfAnotherSonarAsOftenAsAsked) {
  const World world(without_floor(room(4.0)));
  SonarRing::Options options = exact();
  options.angles = {0.0, 3.14159265358979};
  options.crosstalk = 0.25;
  SonarRing ring(options, 1);
  int crossed = 0;
  constexpr int kPings = 4000;
  for (int i = 0; i < kPings; ++i) {
    const double range = ring.sense(0, world, planar_pose(1.0, 2.0, 0.0)).range;
    if (std::abs(range - 1.0) < 1e-6) ++crossed;
  }
  EXPECT_NEAR(crossed, 0.25 * kPings, 110);
}

}  // namespace
}  // namespace portolan::sim
