// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/scan_surface.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "graph/match/flat_world.hpp"

namespace portolan {
namespace {

RangeScan scan_of(const std::vector<float>& ranges) {
  RangeScan scan;
  scan.angle_min = -0.05;
  scan.angle_increment = 0.05;
  scan.range_min = 0.1;
  scan.range_max = 20.0;
  scan.ranges = ranges;
  return scan;
}

TEST(ScanSurface, FacesTheSensor) {
  std::mt19937_64 random(1);
  const Surface surface =
      scan_surface(room().scan(Pose::Identity(), 360, 0.0, random), SurfaceOptions{});
  ASSERT_GT(surface.size(), 100U);
  std::size_t faced = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Eigen::Vector3d& n = surface.normals[i];
    if (n.isZero(0.0)) continue;
    ++faced;
    EXPECT_NEAR(n.norm(), 1.0, 1e-9);
    EXPECT_LT(n.dot(surface.points[i]), 1e-9);
  }
  EXPECT_GT(faced, surface.size() * 9 / 10);
}

TEST(ScanSurface, HoldsNothingOfWhatDidNotReturn) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(scan_surface(scan_of({inf, nan, -inf, 0.0F, 0.05F, 20.0F}), {}).empty());
  EXPECT_TRUE(scan_surface(scan_of({}), {}).empty());
  SurfaceOptions near;
  near.max_range = 1.0;
  EXPECT_TRUE(scan_surface(scan_of({2.0F, 2.0F, 2.0F}), near).empty());
}

TEST(ScanSurface, KnowsNoDirectionOfLonelyEchoes) {
  const Surface surface = scan_surface(scan_of({2.0F, 9.0F, 4.0F}), {});
  ASSERT_EQ(surface.size(), 3U);
  for (const Eigen::Vector3d& n : surface.normals) EXPECT_TRUE(n.isZero(0.0));
}

TEST(ScanSurface, UnwindsASlowSweep) {
  RangeScan scan = scan_of({2.0F, 2.0F, 2.0F});
  scan.T_first_last = planar_pose(0.4, 0.0, 0.0);
  const Surface surface = scan_surface(scan, {});
  ASSERT_EQ(surface.size(), 3U);
  EXPECT_NEAR(surface.points[0].x(), 2.0 * std::cos(0.05), 1e-6);
  EXPECT_NEAR(surface.points[1].x(), 2.2, 1e-6);
  EXPECT_NEAR(surface.points[2].x(), 2.0 * std::cos(0.05) + 0.4, 1e-6);
}

TEST(Surface, IsThinnedToOnePointACube) {
  Surface surface;
  surface.add({0.01, 0.01, 0.0}, Eigen::Vector3d::UnitX());
  surface.add({0.02, 0.02, 0.0}, Eigen::Vector3d::UnitY());
  surface.add({-0.01, 0.01, 0.0}, Eigen::Vector3d::UnitZ());
  const Surface thin = thinned(surface, 0.1);
  ASSERT_EQ(thin.size(), 2U);
  EXPECT_EQ(thin.normals[0], Eigen::Vector3d::UnitX());
  EXPECT_EQ(thin.normals[1], Eigen::Vector3d::UnitZ());
  EXPECT_EQ(thinned(surface, 0.0).size(), 3U);
}

}  // namespace
}  // namespace portolan
