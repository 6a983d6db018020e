// SPDX-License-Identifier: BSD-3-Clause
// Directions that were found from the points that returned, against those of the sensors
// themselves.
#include "portolan/observation/missing_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "portolan/sim/depth_camera.hpp"
#include "portolan/sim/lidar.hpp"
#include "portolan/sim/optical_frame.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

using Directions = std::vector<Eigen::Vector3f>;

void expect_near(const Directions& found, const Directions& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT((found[i] - expected[i]).norm(), 1e-3) << i;
  }
}

/// Turns what every third place without return says into NaN and every other third into too near,
/// and expects the former under unknown and the latter nowhere.
void expect_found(OrganizedCloud organized) {
  ASSERT_GT(organized.cloud.no_returns.size(), 50u);
  Directions nothing_returned;
  Directions unknown;
  std::size_t n = 0;
  for (Eigen::Vector3f& p : organized.cloud.points) {
    if (p.allFinite()) continue;
    const Eigen::Vector3f& direction = organized.cloud.no_returns[n];
    if (n % 3 == 0) nothing_returned.push_back(direction);
    if (n % 3 == 1) {
      unknown.push_back(direction);
      p.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
    if (n % 3 == 2) p = -p;
    ++n;
  }
  const auto found = missing_directions(organized.cloud.points, organized.width);
  expect_near(found.nothing_returned, nothing_returned);
  expect_near(found.unknown, unknown);
}

bool is_empty(const MissingDirections& found) {
  return found.nothing_returned.empty() && found.unknown.empty();
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
  expect_found(DepthCamera({}, 1).sense(wall(), kHere * T_body_optical()));
}

TEST(MissingDirections, OfACameraThatLooksAlongX) {
  OrganizedCloud organized = DepthCamera({}, 1).sense(wall(), kHere * T_body_optical());
  const Eigen::Matrix3f R = T_body_optical().linear().cast<float>();
  for (Eigen::Vector3f& p : organized.cloud.points) p = Eigen::Vector3f(p.z(), -p.x(), -p.y());
  for (Eigen::Vector3f& direction : organized.cloud.no_returns) direction = R * direction;
  expect_found(organized);
}

TEST(MissingDirections, OfALaserThatTurns) { expect_found(Lidar({}, 1).sense(wall(), kHere)); }

TEST(MissingDirections, AreNotGuessed) {
  OrganizedCloud organized = DepthCamera({}, 1).sense(wall(), kHere * T_body_optical());
  auto& points = organized.cloud.points;
  EXPECT_TRUE(is_empty(missing_directions(points, organized.width + 1)));  // other rows than it has
  EXPECT_TRUE(is_empty(missing_directions({points.begin(), points.begin() + 80}, 80)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double turn = 0.7 * static_cast<double>(i * i % 101);
    if (points[i].allFinite()) {
      points[i].x() += static_cast<float>(std::sin(turn));
      points[i].y() += static_cast<float>(std::cos(turn));
    }
  }
  EXPECT_TRUE(is_empty(missing_directions(points, organized.width)));
  EXPECT_TRUE(is_empty(missing_directions({}, 80)));
}

}  // namespace
}  // namespace portolan::sim
