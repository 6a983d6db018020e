// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/obstacle.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "portolan/sim/random.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

Obstacle any_obstacle(Random& random) {
  const WorldOptions one = clutter(1, 1.0, random);
  return World(one).obstacles()[random.index(2)];
}

bool is_inside(const Obstacle& obstacle, const Eigen::Vector3d& p) {
  return p.z() >= obstacle.bottom && p.z() <= obstacle.top &&
         distance(obstacle, p.head<2>()) == 0.0;
}

TEST(Obstacle, ARayMeetsTheFirstPointThatIsInside) {
  Random random(1, "obstacle");
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Obstacle obstacle = any_obstacle(random);
    const Eigen::Vector3d origin(random.uniform(-2, 2), random.uniform(-2, 2),
                                 random.uniform(0, 1));
    const Ray ray{origin, any_direction(random)};
    const auto hit = intersect(obstacle, ray, 20.0);
    const double before = hit ? hit->range : 20.0;
    for (double range = 0.0; range < before - 1e-6; range += 0.02) {
      ASSERT_FALSE(is_inside(obstacle, ray.origin + range * ray.direction));
    }
    if (!hit) continue;
    ++met;
    EXPECT_TRUE(is_inside(obstacle, ray.origin + (hit->range + 1e-7) * ray.direction));
    EXPECT_NEAR(hit->normal.norm(), 1.0, 1e-9);
    EXPECT_LT(hit->normal.dot(ray.direction), 1e-12);
  }
  EXPECT_GT(met, 150);
}

TEST(Obstacle, ARayThatStartsInsideMeetsItAtOnce) {
  Obstacle block;
  block.half = {1.0, 1.0};
  block.top = 1.0;
  const auto hit = intersect(block, {{0.5, 0.5, 0.5}, Eigen::Vector3d::UnitX()}, 10.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->range, 0.0);
}

TEST(Obstacle, NormalsPointOutOfTheFaceThatWasMet) {
  Obstacle block;
  block.half = {1.0, 1.0};
  block.top = 1.0;
  const auto side = intersect(block, {{-3.0, 0.2, 0.5}, Eigen::Vector3d::UnitX()}, 10.0);
  EXPECT_NEAR(side->range, 2.0, 1e-12);
  EXPECT_TRUE(side->normal.isApprox(-Eigen::Vector3d::UnitX()));
  const auto lid = intersect(block, {{0.3, 0.2, 3.0}, -Eigen::Vector3d::UnitZ()}, 10.0);
  EXPECT_NEAR(lid->range, 2.0, 1e-12);
  EXPECT_TRUE(lid->normal.isApprox(Eigen::Vector3d::UnitZ()));
}

TEST(Obstacle, OverlapsASquareWhereAPointOfItIsInside) {
  Random random(2, "overlap");
  int yes = 0;
  for (int i = 0; i < 2000; ++i) {
    const Obstacle obstacle = any_obstacle(random);
    const Eigen::Vector2d center(random.uniform(-2, 2), random.uniform(-2, 2));
    const double half = random.uniform(0.05, 0.5);
    double nearest = 1e9;
    constexpr int kSteps = 40;
    for (int a = -kSteps; a <= kSteps; ++a) {
      for (int b = -kSteps; b <= kSteps; ++b) {
        const Eigen::Vector2d p = center + half / kSteps * Eigen::Vector2d(a, b);
        nearest = std::min(nearest, distance(obstacle, p));
      }
    }
    const bool overlap = overlaps(obstacle, center, half);
    if (nearest == 0.0) {
      EXPECT_TRUE(overlap);
    }
    if (nearest > half / kSteps) {
      EXPECT_FALSE(overlap);
    }
    yes += overlap ? 1 : 0;
  }
  EXPECT_GT(yes, 100);
}

TEST(Obstacle, TouchingASquareIsNoOverlap) {
  Obstacle block;
  block.half = {0.5, 0.5};
  EXPECT_FALSE(overlaps(block, {0.6, 0.0}, 0.1));
  EXPECT_TRUE(overlaps(block, {0.599, 0.0}, 0.1));
}

}  // namespace
}  // namespace portolan::sim
