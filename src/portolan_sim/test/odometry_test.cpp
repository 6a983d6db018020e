// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/odometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "portolan/sim/robot.hpp"

namespace portolan::sim {
namespace {

Odometry::Options perfect() {
  Odometry::Options options;
  options.alpha1 = options.alpha2 = options.alpha3 = options.alpha4 = 0.0;
  return options;
}

/// Straight on, a curve, a turn on the spot, backwards: read so many times a second.
std::vector<Pose> journey(int rate) {
  const std::vector<Velocity> legs = {{0.5, 0.0}, {0.5, 0.4}, {0.0, -0.9}, {-0.3, 0.1}};
  std::vector<Pose> poses = {planar_pose(3.0, -1.0, 2.5)};
  for (const Velocity& velocity : legs) {
    for (int i = 0; i < 4 * rate; ++i) poses.push_back(poses.back() * driven(velocity, 1.0 / rate));
  }
  return poses;
}

Odometry after(const std::vector<Pose>& poses, const Odometry::Options& options,
               std::uint64_t seed) {
  Odometry odometry(options, seed);
  for (const Pose& pose : poses) odometry.update(pose);
  return odometry;
}

Eigen::Vector3d error_of(const Odometry& odometry, const std::vector<Pose>& poses) {
  const Pose truth = poses.front().inverse() * poses.back();
  const Eigen::Vector3d off = odometry.T_odom_base().translation() - truth.translation();
  return {off.x(), off.y(), wrap_angle(yaw(odometry.T_odom_base()) - yaw(truth))};
}

TEST(Odometry, WithoutNoiseIsTheMotionSinceTheStart) {
  const std::vector<Pose> poses = journey(20);
  EXPECT_LT(error_of(after(poses, perfect(), 0), poses).norm(), 1e-9);
}

TEST(Odometry, DriftsAsTold) {
  Odometry::Options options = perfect();
  options.distance_scale = 1.1;
  options.turn_per_metre = 0.05;
  std::vector<Pose> poses;
  for (int i = 0; i <= 100; ++i) poses.push_back(planar_pose(0.1 * i, 0.0, 0.0));
  const Odometry odometry = after(poses, options, 0);
  EXPECT_NEAR(yaw(odometry.T_odom_base()), 0.5, 1e-9);
  const double radius = 11.0 / 0.5;
  EXPECT_NEAR(odometry.T_odom_base().translation().x(), radius * std::sin(0.5), 0.01);

  Odometry::Options more_turn = perfect();
  more_turn.turn_scale = 1.5;
  const Odometry turned = after({planar_pose(0, 0, 0), planar_pose(0, 0, 0.4)}, more_turn, 0);
  EXPECT_NEAR(yaw(turned.T_odom_base()), 0.6, 1e-9);
}

TEST(Odometry, ErrorsAreConsistentWithTheCovarianceItStates) {
  const std::vector<Pose> poses = journey(20);
  double nees = 0.0;
  constexpr int kRuns = 400;
  for (int seed = 0; seed < kRuns; ++seed) {
    const Odometry odometry = after(poses, Odometry::Options{}, static_cast<std::uint64_t>(seed));
    const Eigen::Vector3d error = error_of(odometry, poses);
    nees += error.dot(odometry.covariance().inverse() * error) / kRuns;
  }
  // chi squared with 1200 degrees of freedom, over 400: 99.9 % lie within 3 +- 0.41.
  EXPECT_NEAR(nees, 3.0, 0.41);
}

TEST(Odometry, DriftDoesNotDependOnHowOftenItIsRead) {
  const Odometry seldom = after(journey(5), Odometry::Options{}, 1);
  const Odometry often = after(journey(100), Odometry::Options{}, 2);
  for (int i = 0; i < 3; ++i) {
    const double ratio = seldom.covariance()(i, i) / often.covariance()(i, i);
    EXPECT_NEAR(ratio, 1.0, 0.1);
  }
}

TEST(Odometry, EachParameterActsOnItsPart) {
  const auto variance = [](double Odometry::Options::*alpha, const Pose& motion) {
    Odometry::Options options = perfect();
    options.*alpha = 0.01;
    const Eigen::Matrix3d covariance = after({Pose::Identity(), motion}, options, 0).covariance();
    return Eigen::Vector3d(covariance.diagonal());
  };
  const Pose turn = planar_pose(0.0, 0.0, 0.5);
  const Pose straight = planar_pose(2.0, 0.0, 0.0);
  EXPECT_NEAR(variance(&Odometry::Options::alpha1, turn).z(), 0.01 * 0.5, 1e-12);
  EXPECT_EQ(variance(&Odometry::Options::alpha1, straight).norm(), 0.0);
  EXPECT_NEAR(variance(&Odometry::Options::alpha2, straight).z(), 0.01 * 2.0, 1e-12);
  EXPECT_EQ(variance(&Odometry::Options::alpha2, turn).norm(), 0.0);
  EXPECT_NEAR(variance(&Odometry::Options::alpha3, straight).x(), 0.01 * 2.0, 1e-12);
  EXPECT_EQ(variance(&Odometry::Options::alpha3, turn).norm(), 0.0);
  EXPECT_NEAR(variance(&Odometry::Options::alpha4, turn).head<2>().sum(), 0.01 * 0.5, 1e-12);
  EXPECT_EQ(variance(&Odometry::Options::alpha4, straight).norm(), 0.0);
}

}  // namespace
}  // namespace portolan::sim
