// SPDX-License-Identifier: BSD-3-Clause
// Directions that were found from the points that returned, against those of the sensors
// themselves.
#include "portolan/observation/missing_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "portolan/sim/depth_camera.hpp"
#include "portolan/sim/lidar.hpp"
#include "portolan/sim/optical_frame.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

/// As `missing_directions` sees it, with what is too close missing too.
void expect_found(const OrganizedCloud& organized, double tolerance) {
  const auto found = missing_directions(organized.cloud.points, organized.width);
  ASSERT_EQ(found.size(), organized.cloud.no_returns.size());
  ASSERT_GT(found.size(), 50u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT((found[i] - organized.cloud.no_returns[i]).norm(), tolerance) << i;
  }
}

/// A wall ahead on the left; beyond, nothing.
World wall() {
  WorldOptions options;
  options.floor = false;
  options.walls.resize(1);
  options.walls[0].points = {{3.0, -0.3}, {3.0, 6.0}};
  options.walls[0].height = 6.0;
  return World(options);
}

const Pose kHere(Eigen::Translation3d(0.0, 0.0, 3.0));

TEST(MissingDirections, OfACamera) {
  expect_found(DepthCamera({}, 1).sense(wall(), kHere * T_body_optical()), 1e-3);
}

TEST(MissingDirections, OfACameraThatLooksAlongX) {
  OrganizedCloud organized = DepthCamera({}, 1).sense(wall(), kHere * T_body_optical());
  const Eigen::Matrix3f R = T_body_optical().linear().cast<float>();
  for (Eigen::Vector3f& p : organized.cloud.points) p = R * p;
  for (Eigen::Vector3f& direction : organized.cloud.no_returns) direction = R * direction;
  expect_found(organized, 1e-3);
}

TEST(MissingDirections, OfALaserThatTurns) {
  expect_found(Lidar({}, 1).sense(wall(), kHere), 1e-3);
}

TEST(MissingDirections, AreNotGuessed) {
  OrganizedCloud organized = DepthCamera({}, 1).sense(wall(), kHere * T_body_optical());
  auto& points = organized.cloud.points;
  EXPECT_TRUE(missing_directions(points, organized.width + 1).empty());  // other rows than it has
  EXPECT_TRUE(missing_directions({points.begin(), points.begin() + 80}, 80).empty());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double turn = 0.7 * static_cast<double>(i * i % 101);
    if (points[i].allFinite()) {
      points[i].x() += static_cast<float>(std::sin(turn));
      points[i].y() += static_cast<float>(std::cos(turn));
    }
  }
  EXPECT_TRUE(missing_directions(points, organized.width).empty());
  EXPECT_TRUE(missing_directions({}, 80).empty());
}

}  // namespace
}  // namespace portolan::sim
