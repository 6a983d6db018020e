// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/scan_detectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "landmark/dice.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kStddev = 0.02;

/// 360 beams of a degree each; `distance(angle)` says what stands there.
template <class Distance>
RangeScan scan_of(const Distance& distance, Dice* dice = nullptr) {
  RangeScan scan;
  scan.angle_min = -M_PI;
  scan.angle_increment = M_PI / 360.0;
  scan.range_min = 0.1;
  scan.range_max = 40.0;
  for (int i = 0; i < 720; ++i) {
    const double range = distance(scan.angle_min + i * scan.angle_increment);
    const double error = dice != nullptr ? dice->normal(kStddev) : 0.0;
    scan.ranges.push_back(static_cast<float>(range + error));
  }
  return scan;
}

double to_circle(double angle, const Eigen::Vector2d& center, double radius) {
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  const double along = u.dot(center);
  const double inside = radius * radius - (center.squaredNorm() - along * along);
  return along > 0.0 && inside > 0.0 ? along - std::sqrt(inside) : kNothing;
}

/// A square room of half the side, seen from its middle.
double to_room(double angle, double half) {
  return half / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
}

Eigen::Vector2d place(const LandmarkSighting& s) {
  return {s.range * std::cos(s.azimuth), s.range * std::sin(s.azimuth)};
}

TEST(PoleDetector, FindsPolesAndNotTheWallBehind) {
  const Eigen::Vector2d a(2.0, 1.0);
  const Eigen::Vector2d b(-3.0, 0.5);
  const RangeScan scan = scan_of([&](double angle) {
    return std::min({to_circle(angle, a, 0.1), to_circle(angle, b, 0.25), to_room(angle, 6.0)});
  });
  const LandmarkSightings z = detect_poles(scan, {}, {});
  ASSERT_EQ(z.sightings.size(), 2u);
  EXPECT_LT((place(z.sightings[0]) - a).norm(), 0.05);
  EXPECT_LT((place(z.sightings[1]) - b).norm(), 0.05);
  EXPECT_TRUE(std::isnan(z.sightings[0].elevation));
  EXPECT_EQ(z.sightings[0].id, LandmarkSighting::kUnknown);
}

TEST(PoleDetector, StatesTheErrorsThatItMakes) {
  const Eigen::Vector2d pole(3.0, 0.2);
  double azimuth = 0.0;
  double range = 0.0;
  int found = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const RangeScan scan =
        scan_of([&](double angle) { return to_circle(angle, pole, 0.2); }, &dice);
    const LandmarkSightings z = detect_poles(scan, {}, {});
    if (z.sightings.size() != 1) continue;
    const LandmarkSighting& s = z.sightings[0];
    ++found;
    azimuth += std::pow((s.azimuth - std::atan2(0.2, 3.0)) / s.azimuth_stddev, 2);
    range += std::pow((s.range - pole.norm()) / s.range_stddev, 2);
  }
  ASSERT_GT(found, 150);
  EXPECT_LT(azimuth / found, 1.6);
  EXPECT_GT(azimuth / found, 0.3);
  EXPECT_LT(range / found, 1.6);
  EXPECT_GT(range / found, 0.1);
}

TEST(PoleDetector, APieceOfWallIsNoPole) {
  const RangeScan scan = scan_of([](double angle) { return to_room(angle, 5.0); });
  EXPECT_TRUE(detect_poles(scan, {}, {}).sightings.empty());
}

TEST(CornerDetector, FindsTheFourCornersOfARoom) {
  Dice dice(1);
  const RangeScan scan = scan_of([](double angle) { return to_room(angle, 3.0); }, &dice);
  const LandmarkSightings z = detect_corners(scan, {}, {});
  ASSERT_EQ(z.sightings.size(), 4u);
  for (const LandmarkSighting& s : z.sightings) {
    const Eigen::Vector2d p = place(s);
    const Eigen::Vector2d corner(std::copysign(3.0, p.x()), std::copysign(3.0, p.y()));
    EXPECT_LT((p - corner).norm(), 0.05);
    EXPECT_LT((p - corner).norm(), 5.0 * std::hypot(s.range_stddev, s.range * s.azimuth_stddev));
  }
}

TEST(CornerDetector, AnEdgeBeforeABackgroundIsNoCorner) {
  const RangeScan scan = scan_of([](double angle) {
    return angle > 0.0 && angle < 1.0 ? 2.0 / std::cos(angle - 0.5) : kNothing;
  });
  EXPECT_TRUE(detect_corners(scan, {}, {}).sightings.empty());
}

TEST(ReflectorDetector, FindsWhatShines) {
  const RangeScan scan = scan_of([](double angle) { return to_room(angle, 4.0); });
  std::vector<float> intensities(scan.ranges.size(), 100.0F);
  for (std::size_t beam = 358; beam <= 362; ++beam) intensities[beam] = 2000.0F;
  intensities[100] = std::numeric_limits<float>::quiet_NaN();
  const LandmarkSightings z = detect_reflectors(scan, intensities, {}, {});
  ASSERT_EQ(z.sightings.size(), 1u);
  EXPECT_LT((place(z.sightings[0]) - Eigen::Vector2d(4.0, 0.0)).norm(), 0.01);
  EXPECT_GT(z.sightings[0].azimuth_stddev, 0.0);
}

TEST(ReflectorDetector, AWideOneIsSomethingElse) {
  const RangeScan scan = scan_of([](double angle) { return to_room(angle, 4.0); });
  const std::vector<float> intensities(scan.ranges.size(), 2000.0F);
  EXPECT_TRUE(detect_reflectors(scan, intensities, {}, {}).sightings.empty());
  EXPECT_TRUE(detect_reflectors(scan, {}, {}, {}).sightings.empty());
}

TEST(ScanDetectors, UnwindTheMotionOfTheSweep) {
  // The sensor drives 0.5 m towards the pole while it turns once.
  const Eigen::Vector2d pole(3.0, 0.0);
  RangeScan scan;
  scan.angle_min = -M_PI;
  scan.angle_increment = M_PI / 360.0;
  scan.range_max = 40.0;
  for (int i = 0; i < 720; ++i) {
    const Eigen::Vector2d here(0.5 * i / 719.0, 0.0);
    const double angle = scan.angle_min + i * scan.angle_increment;
    scan.ranges.push_back(static_cast<float>(to_circle(angle, pole - here, 0.2)));
  }
  scan.T_first_last = planar_pose(0.5, 0.0, 0.0);
  const LandmarkSightings z = detect_poles(scan, {}, {});
  ASSERT_EQ(z.sightings.size(), 1u);
  EXPECT_LT((place(z.sightings[0]) - pole).norm(), 0.03);
}

}  // namespace
}  // namespace portolan
