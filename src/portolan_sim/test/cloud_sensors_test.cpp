// SPDX-License-Identifier: BSD-3-Clause
// Lidar and depth camera: two ways to sample one cloud.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "portolan/sim/depth_camera.hpp"
#include "portolan/sim/lidar.hpp"
#include "portolan/sim/optical_frame.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

template <class Options>
Options exact() {
  Options options;
  options.noise.range_stddev = options.noise.stddev_per_metre = 0.0;
  options.noise.range_min = 0.1;
  return options;
}

double distance_to_room(const Eigen::Vector3d& p, double side) {
  return std::min({std::abs(p.x()), std::abs(p.y()), std::abs(p.x() - side), std::abs(p.y() - side),
                   std::abs(p.z())});
}

void expect_points_on_room(const OrganizedCloud& organized, const Pose& T_map_sensor) {
  ASSERT_EQ(organized.cloud.points.size(), std::size_t{organized.width} * organized.height);
  std::size_t missing = 0;
  for (const Eigen::Vector3f& point : organized.cloud.points) {
    if (!point.allFinite()) {
      ++missing;
    } else {
      const Eigen::Vector3d p_map = T_map_sensor * point.cast<double>();
      EXPECT_NEAR(distance_to_room(p_map, 4.0), 0.0, 1e-4);
      EXPECT_GT(p_map.z(), -1e-4);
    }
  }
  EXPECT_EQ(missing, organized.cloud.no_returns.size());
  for (const Eigen::Vector3f& direction : organized.cloud.no_returns) {
    EXPECT_NEAR(direction.norm(), 1.0F, 1e-5F);
  }
}

const Pose kMiddle = Eigen::Translation3d(0, 0, 0.6) * planar_pose(1.5, 2.0, 0.3);

TEST(Lidar, PointsLieOnWallsAndFloor) {
  Lidar lidar(exact<Lidar::Options>(), 1);
  expect_points_on_room(lidar.sense(World(room(4.0)), kMiddle), kMiddle);
}

TEST(Lidar, RingsRiseFromRowToRow) {
  Lidar::Options options = exact<Lidar::Options>();
  options.rings = 5;
  options.columns = 36;
  Lidar lidar(options, 1);
  const OrganizedCloud organized = lidar.sense(World(room(4.0)), kMiddle);
  for (std::size_t i = 0; i < organized.cloud.points.size(); ++i) {
    const Eigen::Vector3f& p = organized.cloud.points[i];
    const double step = (options.highest - options.lowest) / 4.0;
    const std::size_t row = i / 36;
    const double expected = options.lowest + static_cast<double>(row) * step;
    EXPECT_NEAR(std::asin(p.z() / p.norm()), expected, 1e-4);
  }
}

TEST(Lidar, NothingReturnsFromAnEmptyWorld) {
  WorldOptions empty;
  empty.floor = false;
  Lidar lidar(exact<Lidar::Options>(), 1);
  const OrganizedCloud organized = lidar.sense(World(empty), kMiddle);
  EXPECT_EQ(organized.cloud.no_returns.size(), 16U * 900U);
}

TEST(DepthCamera, PointsLieOnWallsAndFloorInTheOpticalFrame) {
  DepthCamera camera(exact<DepthCamera::Options>(), 1);
  const Pose T_map_optical = kMiddle * T_body_optical();
  const OrganizedCloud organized = camera.sense(World(room(4.0)), T_map_optical);
  expect_points_on_room(organized, T_map_optical);
  for (const Eigen::Vector3f& point : organized.cloud.points) EXPECT_GT(point.z(), 0.0F);
  EXPECT_LT(organized.cloud.points.front().x(), 0.0F);
  EXPECT_LT(organized.cloud.points.front().y(), 0.0F);
}

TEST(DepthCamera, SeesAsWideAsItsFieldOfView) {
  DepthCamera::Options options = exact<DepthCamera::Options>();
  options.width = 1001;
  options.height = 1;
  DepthCamera camera(options, 1);
  const OrganizedCloud organized = camera.sense(World(room(4.0)), kMiddle * T_body_optical());
  const Eigen::Vector3f& left = organized.cloud.points.front();
  EXPECT_NEAR(std::atan2(-left.x(), left.z()), 0.5 * options.field_of_view, 0.002);
}

}  // namespace
}  // namespace portolan::sim
