// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ground_filter.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

const Pose kSensor =
    Pose(Eigen::Translation3d(0.1, 0.0, 0.8)) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());

/// A floor that rises by `slope` along x, with noise, and a box that stands on it.
PointCloud scene(Random& random, double slope, std::size_t floor, std::size_t box) {
  PointCloud cloud;
  const Pose T_sensor_base = kSensor.inverse();
  const auto add = [&](double x, double y, double z) {
    cloud.points.emplace_back((T_sensor_base * Eigen::Vector3d(x, y, z)).cast<float>());
  };
  for (std::size_t i = 0; i < floor; ++i) {
    const double x = uniform(random, 0.5, 4.0);
    add(x, uniform(random, -2.0, 2.0), slope * x + uniform(random, -0.01, 0.01));
  }
  for (std::size_t i = 0; i < box; ++i) {
    add(2.0, uniform(random, -0.5, 0.5), 2.0 * slope + uniform(random, 0.1, 1.0));
  }
  return cloud;
}

TEST(GroundFilter, splits_floor_and_box) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const GroundedCloud split =
        split_ground(scene(random, 0.0, 3000, 1000), kSensor, GroundFilter{});
    EXPECT_EQ(split.ground.size(), 3000U);
    EXPECT_EQ(split.obstacles.points.size(), 1000U);
  }
}

TEST(GroundFilter, follows_a_floor_that_is_not_level) {
  Random random(1);
  const double slope = 0.1;
  const PointCloud cloud = scene(random, slope, 3000, 1000);
  const auto plane = find_ground(cloud, kSensor, GroundFilter{});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->normal.x(), -slope / std::sqrt(1.0 + slope * slope), 0.01);
  EXPECT_NEAR(plane->offset, 0.0, 0.01);
  EXPECT_EQ(split_ground(cloud, kSensor, GroundFilter{}).ground.size(), 3000U);
}

TEST(GroundFilter, does_not_take_a_table_or_a_ramp_for_the_ground) {
  Random random(2);
  PointCloud table;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p(uniform(random, 1.0, 2.0), uniform(random, -0.5, 0.5), 0.5);
    table.points.emplace_back((kSensor.inverse() * p).cast<float>());
  }
  EXPECT_FALSE(find_ground(table, kSensor, GroundFilter{}));
  EXPECT_EQ(split_ground(table, kSensor, GroundFilter{}).obstacles.points.size(), 1000U);
  EXPECT_FALSE(find_ground(scene(random, 0.5, 1000, 0), kSensor, GroundFilter{}));
}

TEST(GroundFilter, falls_back_on_the_base_plane_where_too_little_is_seen_of_the_floor) {
  Random random(3);
  const PointCloud cloud = scene(random, 0.0, 5, 300);
  EXPECT_FALSE(find_ground(cloud, kSensor, GroundFilter{}));
  const GroundedCloud split = split_ground(cloud, kSensor, GroundFilter{});
  EXPECT_EQ(split.ground.size(), 5U);
  EXPECT_EQ(split.obstacles.points.size(), 300U);
}

TEST(GroundFilter, gives_the_same_for_the_same_and_survives_nothing) {
  Random random(4);
  const PointCloud cloud = scene(random, 0.02, 500, 200);
  EXPECT_EQ(split_ground(cloud, kSensor, GroundFilter{}).ground,
            split_ground(cloud, kSensor, GroundFilter{}).ground);
  EXPECT_TRUE(split_ground(PointCloud{}, kSensor, GroundFilter{}).ground.empty());
}

}  // namespace
}  // namespace portolan::octo_test
