// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/icp.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "graph/match/flat_world.hpp"
#include "portolan/graph/match/scan_surface.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {
namespace {

constexpr double kNoise = 0.01;  // of a range [m]

Surface seen(const FlatWorld& world, const Pose& T_map_sensor, std::uint64_t seed,
             double noise = kNoise) {
  std::mt19937_64 random(seed);
  return scan_surface(world.scan(T_map_sensor, 360, noise, random), SurfaceOptions{});
}

Match match_in(const FlatWorld& world, const Pose& T_target_source, const Pose& T_guess,
               std::uint64_t seed = 1, double noise = kNoise) {
  const Surface target = seen(world, Pose::Identity(), 2 * seed, noise);
  const Surface source = seen(world, T_target_source, 2 * seed + 1, noise);
  return icp(SurfaceIndex(target), source, T_guess, GraphSpace::planar, IcpOptions{});
}

struct Error {
  double position;  // [m]
  double heading;   // [rad]
};

Error error_of(const Match& match, const Pose& T_target_source) {
  const Pose difference = T_target_source.inverse() * match.T_target_source;
  return {difference.translation().norm(), std::abs(yaw(difference))};
}

TEST(Icp, FindsTheMotionWithoutNoise) {
  const Pose T = planar_pose(0.31, -0.22, 0.17);
  const Match match = match_in(room(), T, Pose::Identity(), 1, 0.0);
  EXPECT_TRUE(match.converged);
  EXPECT_TRUE(match.open.empty());
  EXPECT_LT(error_of(match, T).position, 2e-3);
  EXPECT_LT(error_of(match, T).heading, 1e-3);
  EXPECT_GT(match.overlap, 0.9);
}

TEST(Icp, FindsTheMotionFromAGridOfGuesses) {
  const Pose T = planar_pose(0.2, 0.1, -0.1);
  int tried = 0;
  int found = 0;
  for (double away = 0.0; away <= 0.5; away += 0.25) {
    for (double toward = 0.0; toward < 6.0; toward += 1.0) {
      for (double turned = -0.3; turned <= 0.31; turned += 0.15) {
        const Pose guess =
            T * planar_pose(away * std::cos(toward), away * std::sin(toward), turned);
        const Match match = match_in(room(), T, guess, 7);
        const Error error = error_of(match, T);
        ++tried;
        found += match.converged && error.position < 0.03 && error.heading < 0.01 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(found, tried * 95 / 100) << "of " << tried;
}

TEST(Icp, LeavesTheWayAlongACorridorOpenAndAtTheGuess) {
  const Pose T = planar_pose(0.4, 0.1, 0.05);
  const Pose guess = planar_pose(0.55, 0.0, 0.0);
  const Match match = match_in(corridor(), T, guess, 3);
  ASSERT_TRUE(match.converged);
  ASSERT_EQ(match.open.size(), 1U);
  const Eigen::Vector3d along = match.T_target_source.linear() * match.open[0].head<3>();
  EXPECT_GT(std::abs(along.x()), 0.99);
  EXPECT_LT(match.open[0].dot(match.information * match.open[0]), 1e-6);
  EXPECT_NEAR(match.T_target_source.translation().y(), 0.1, 0.02);
  EXPECT_NEAR(yaw(match.T_target_source), 0.05, 0.01);
  EXPECT_NEAR(match.T_target_source.translation().x(), 0.55, 0.03);
}

TEST(Icp, LeavesTheTurnInACircleOpenAndAtTheGuess) {
  FlatWorld world;
  world.circle(3.0, 720);
  const Match match = match_in(world, planar_pose(0.1, 0.0, 0.5), planar_pose(0.0, 0.0, 0.2), 4);
  ASSERT_TRUE(match.converged);
  ASSERT_EQ(match.open.size(), 1U);
  EXPECT_GT(std::abs(match.open[0][5]), 0.9);
  EXPECT_NEAR(yaw(match.T_target_source), 0.2, 0.05);
}

TEST(Icp, SaysThatThereIsNoMatch) {
  const Surface good = seen(room(), Pose::Identity(), 1);
  Surface few;
  for (std::size_t i = 0; i < 4; ++i) few.add(good.points[i], good.normals[i]);
  for (const Surface& bad : {Surface{}, few}) {
    EXPECT_FALSE(icp(SurfaceIndex(good), bad, Pose::Identity(), GraphSpace::planar, {}).converged);
    EXPECT_FALSE(icp(SurfaceIndex(bad), good, Pose::Identity(), GraphSpace::planar, {}).converged);
  }
  const Pose far = planar_pose(100.0, 0.0, 0.0);
  const Match match = icp(SurfaceIndex(good), good, far, GraphSpace::planar, {});
  EXPECT_FALSE(match.converged);
  EXPECT_TRUE(match.T_target_source.isApprox(far));
  EXPECT_TRUE(match.information.isZero(0.0));
}

TEST(Icp, WithoutBiasTheInformationIsThatOfTheErrors) {
  IcpOptions options;
  options.bias = 1e-6;
  const Pose T = planar_pose(0.2, -0.1, 0.1);
  double nees = 0.0;
  constexpr int kRuns = 60;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    const Surface target = seen(room(), Pose::Identity(), 2 * seed);
    const Surface source = seen(room(), T, 2 * seed + 1);
    const Match match = icp(SurfaceIndex(target), source, T, GraphSpace::planar, options);
    const Tangent v = small_motion(T.inverse() * match.T_target_source);
    nees += v.dot(match.information * v) / kRuns;
  }
  // Three degrees of freedom; neighbouring points share the direction of their surface, so that
  // they are worth less than as many independent ones.
  EXPECT_GT(nees, 1.5);
  EXPECT_LT(nees, 9.0);
}

TEST(Icp, IsTheSameInSpaceWhereTheSurfacesHoldAllDirections) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> at(-2.0, 2.0);
  Surface cube;
  for (int i = 0; i < 1200; ++i) {
    Eigen::Vector3d p(at(random), at(random), at(random));
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    const int axis = i % 3;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    p[axis] = 2.0 * side + 0.3 * axis;
    n[axis] = -side;
    cube.add(p, n);
  }
  Pose T = planar_pose(0.1, -0.05, 0.05);
  T.translation().z() = 0.07;
  T.rotate(Eigen::AngleAxisd(0.04, Eigen::Vector3d::UnitX()));
  Surface source;
  append(cube, T.inverse(), source);
  const Match match = icp(SurfaceIndex(cube), source, Pose::Identity(), GraphSpace::spatial, {});
  EXPECT_TRUE(match.converged);
  EXPECT_TRUE(match.open.empty());
  EXPECT_LT((T.inverse() * match.T_target_source).translation().norm(), 5e-3);
  EXPECT_LT(rotation_angle(T.inverse() * match.T_target_source), 5e-3);
}

}  // namespace
}  // namespace portolan
