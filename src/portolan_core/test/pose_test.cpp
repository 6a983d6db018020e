// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_pose.hpp"

namespace portolan {
namespace {

constexpr double kTolerance = 1e-12;

Pose turned_about(const Eigen::Vector3d& axis, double angle) {
  return Pose(Eigen::AngleAxisd(angle, axis.normalized()));
}

TEST(Pose, PlanarPoseTakesPointsToTheOtherFrame) {
  const Pose T_map_robot = planar_pose(1.0, 2.0, M_PI / 2);
  const Eigen::Vector3d p_map = T_map_robot * Eigen::Vector3d(3.0, 0.0, 0.5);
  EXPECT_TRUE(p_map.isApprox(Eigen::Vector3d(1.0, 5.0, 0.5), kTolerance));
}

TEST(Pose, YawIsThatOfThePlanarPose) {
  for (double angle = -3.1; angle < 3.2; angle += 0.1) {
    EXPECT_NEAR(yaw(planar_pose(4.0, 5.0, angle)), angle, kTolerance);
  }
  EXPECT_EQ(yaw(planar_pose(0.0, 0.0, -M_PI)), M_PI);
}

TEST(Pose, YawIgnoresPitch) {
  const Pose tilted = planar_pose(0.0, 0.0, 2.0) * turned_about(Eigen::Vector3d::UnitY(), 0.7);
  EXPECT_NEAR(yaw(tilted), 2.0, kTolerance);
}

TEST(Pose, WrapAngleIsHalfOpen) {
  EXPECT_EQ(wrap_angle(M_PI), M_PI);
  EXPECT_EQ(wrap_angle(-M_PI), M_PI);
  EXPECT_EQ(wrap_angle(0.0), 0.0);
  for (int turns = -20; turns <= 20; ++turns) {
    for (double angle = -3.1; angle < 3.2; angle += 0.1) {
      EXPECT_NEAR(wrap_angle(angle + 2.0 * M_PI * turns), angle, 1e-13);
    }
  }
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::infinity())));
}

TEST(Pose, RotationAngleIsBetweenZeroAndPi) {
  const Eigen::Vector3d axis(1.0, -2.0, 0.5);
  for (const double angle : {0.0, 1e-9, 1e-4, 0.5, 3.0, M_PI}) {
    EXPECT_NEAR(rotation_angle(turned_about(axis, angle)), angle, 1e-8);
    EXPECT_NEAR(rotation_angle(turned_about(axis, -angle)), angle, 1e-8);
    EXPECT_NEAR(rotation_angle(turned_about(axis, 2.0 * M_PI - angle)), angle, 1e-8);
  }
}

TEST(Pose, InterpolateEndsExactlyAtItsEnds) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose a = random_pose(random);
    const Pose b = random_pose(random);
    EXPECT_EQ(interpolate(a, b, 0.0).matrix(), a.matrix());
    EXPECT_EQ(interpolate(a, b, 1.0).matrix(), b.matrix());
    EXPECT_EQ(interpolate(a, a, 0.3).matrix(), a.matrix());
  }
}

TEST(Pose, InterpolateIsStraightAndTurnsEvenlyTheShortWay) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    const Pose a = random_pose(random);
    const Pose b = random_pose(random);
    const double whole = rotation_angle(a.inverse() * b);
    for (const double fraction : {0.1, 0.5, 0.9}) {
      const Pose between = interpolate(a, b, fraction);
      EXPECT_TRUE(is_valid(between));
      const Eigen::Vector3d way = between.translation() - a.translation();
      EXPECT_TRUE(way.isApprox(fraction * (b.translation() - a.translation()), 1e-9));
      EXPECT_NEAR(rotation_angle(a.inverse() * between), fraction * whole, 1e-7);
      EXPECT_NEAR(rotation_angle(between.inverse() * b), (1.0 - fraction) * whole, 1e-7);
    }
  }
}

TEST(Pose, InterpolateExtrapolates) {
  const Pose a = planar_pose(0.0, 0.0, 0.2);
  const Pose b = planar_pose(1.0, 2.0, 0.5);
  EXPECT_TRUE(interpolate(a, b, 2.0).isApprox(planar_pose(2.0, 4.0, 0.8), kTolerance));
  EXPECT_TRUE(interpolate(a, b, -1.0).isApprox(planar_pose(-1.0, -2.0, -0.1), kTolerance));
}

TEST(Pose, InterpolateCrossesTheSeamOfYaw) {
  const Pose between = interpolate(planar_pose(0, 0, 3.0), planar_pose(0, 0, -3.0), 0.5);
  EXPECT_NEAR(yaw(between), M_PI, 1e-9);
}

TEST(Pose, IsValidAsksForAFiniteRotation) {
  EXPECT_TRUE(is_valid(Pose::Identity()));
  Pose shifted = Pose::Identity();
  shifted.translation().y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_valid(shifted));
  shifted.translation().y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_valid(shifted));
  shifted.translation().y() = -1e30;
  EXPECT_FALSE(is_valid(shifted));
  shifted.translation().y() = 1e7;
  EXPECT_TRUE(is_valid(shifted));
  Pose scaled = Pose::Identity();
  scaled.linear() *= 1.001;
  EXPECT_FALSE(is_valid(scaled));
  Pose mirrored = Pose::Identity();
  mirrored.linear()(2, 2) = -1.0;
  EXPECT_FALSE(is_valid(mirrored));
  Pose flat = Pose::Identity();
  flat.linear().setZero();
  EXPECT_FALSE(is_valid(flat));
}

TEST(Pose, StaysValidOverALongDrive) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> small(0.0, 0.01);
  Pose pose = Pose::Identity();
  for (int i = 0; i < 1'000'000; ++i) {
    pose = pose * Pose(Eigen::AngleAxisd(small(random), Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0));
  }
  EXPECT_TRUE(is_valid(pose));
}

}  // namespace
}  // namespace portolan
