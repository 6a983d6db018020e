// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/laser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

Laser::Options exact() {
  Laser::Options options;
  options.noise.range_stddev = 0.0;
  return options;
}

Pose at(double x, double y, double yaw) {
  return Eigen::Translation3d(0.0, 0.0, 0.2) * planar_pose(x, y, yaw);
}

TEST(Laser, MeasuresASquareRoom) {
  Laser laser(exact(), 1);
  const World world(room(4.0));
  const Pose T_map_laser = at(1.0, 1.5, 0.7);
  const RangeScan scan = laser.sense(world, T_map_laser, T_map_laser);
  ASSERT_TRUE(is_usable(scan));
  ASSERT_EQ(scan.ranges.size(), 360U);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector3d p_laser(scan.ranges[i] * std::cos(angle),
                                  scan.ranges[i] * std::sin(angle), 0.0);
    const Eigen::Vector3d p_map = T_map_laser * p_laser;
    const double to_wall = std::min({std::abs(p_map.x()), std::abs(p_map.y()),
                                     std::abs(p_map.x() - 4.0), std::abs(p_map.y() - 4.0)});
    EXPECT_NEAR(to_wall, 0.0, 1e-5);
  }
}

TEST(Laser, SeesThroughGlassAndOnToSoftThings) {
  Laser laser(exact(), 1);
  const Pose middle = at(2.0, 2.0, 0.0);
  const RangeScan glass = laser.sense(World(room(4.0, Material::glass)), middle, middle);
  const RangeScan soft = laser.sense(World(room(4.0, Material::soft)), middle, middle);
  for (const float range : glass.ranges) EXPECT_TRUE(std::isinf(range));
  for (const float range : soft.ranges) EXPECT_LT(range, 3.0F);
}

TEST(Laser, ASlowSweepSeesEachBeamFromWhereItIsThen) {
  Laser::Options options = exact();
  options.sweep_time = 0.1;
  options.angle_min = -0.001;
  options.angle_max = 0.001;
  options.beams = 5;
  Laser laser(options, 1);
  const RangeScan scan = laser.sense(World(room(4.0)), at(1.0, 2.0, 0.0), at(2.0, 2.0, 0.0));
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(scan.ranges.at(static_cast<std::size_t>(i)), 3.0 - 0.25 * i, 1e-5);
  }
}

TEST(Laser, SameSeedSameScan) {
  const World world(room(4.0));
  const Pose pose = at(1.0, 1.0, 0.0);
  Laser a(Laser::Options{}, 5);
  Laser b(Laser::Options{}, 5);
  Laser c(Laser::Options{}, 6);
  const RangeScan scan = a.sense(world, pose, pose);
  EXPECT_EQ(scan.ranges, b.sense(world, pose, pose).ranges);
  EXPECT_NE(scan.ranges, c.sense(world, pose, pose).ranges);
}

}  // namespace
}  // namespace portolan::sim
