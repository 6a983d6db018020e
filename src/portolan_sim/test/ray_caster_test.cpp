// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/ray_caster.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

/// Asks every obstacle.
std::optional<Hit> cast_slowly(const std::vector<Obstacle>& obstacles, const Ray& ray, Wave wave,
                               double max_range) {
  std::optional<Hit> nearest;
  for (const Obstacle& obstacle : obstacles) {
    if (passes(wave, obstacle.material)) continue;
    const auto hit = intersect(obstacle, ray, max_range);
    if (hit && (!nearest || hit->range < nearest->range)) nearest = hit;
  }
  return nearest;
}

Ray any_ray(Random& random) {
  Ray ray;
  ray.origin = {random.uniform(-12, 12), random.uniform(-12, 12), random.uniform(0, 1)};
  ray.direction = any_direction(random);
  if (random.chance(0.3)) ray.direction = Eigen::Vector3d::Unit(static_cast<int>(random.index(3)));
  if (random.chance(0.5)) ray.direction.z() *= 0.1;
  ray.direction.normalize();
  return ray;
}

TEST(RayCaster, FindsWhatAskingEveryObstacleFinds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed, "rays");
    const World world(clutter(20, 8.0, random));
    const RayCaster caster(world.obstacles());
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = any_ray(random);
      const Wave wave = random.chance(0.5) ? Wave::light : Wave::sound;
      const double max_range = random.uniform(0.5, 30.0);
      const auto fast = caster.cast(ray, wave, max_range);
      const auto slow = cast_slowly(world.obstacles(), ray, wave, max_range);
      ASSERT_EQ(fast.has_value(), slow.has_value());
      if (!fast) continue;
      ++met;
      EXPECT_EQ(fast->range, slow->range);
    }
    EXPECT_GT(met, 200);
  }
}

TEST(RayCaster, ClearanceIsTheDistanceToTheNearestObstacle) {
  Random random(1, "clearance");
  const World world(clutter(20, 8.0, random));
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(random.uniform(-10, 10), random.uniform(-10, 10));
    double slow = 1.5;
    for (const Obstacle& obstacle : world.obstacles()) {
      if (obstacle.bottom >= 0.4 || obstacle.top <= 0.0) continue;
      slow = std::min(slow, distance(obstacle, p));
    }
    EXPECT_EQ(world.clearance(p, 1.5, 0.0, 0.4), slow);
  }
}

TEST(RayCaster, AnEmptyWorldReturnsNothing) {
  const RayCaster caster({});
  EXPECT_FALSE(caster.cast({{0, 0, 0}, Eigen::Vector3d::UnitX()}, Wave::light));
  EXPECT_FALSE(caster.cast({{0.2, 0.2, 0}, Eigen::Vector3d::UnitZ()}, Wave::sound));
}

}  // namespace
}  // namespace portolan::sim
