// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "landmark/dice.hpp"
#include "portolan/landmark/chi_squared.hpp"
#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;

constexpr int kRuns = 50;
constexpr int kSteps = 40;
constexpr std::size_t kDegrees = 2 * kRuns;

/// Vague along the robot's way, in its heading, and in both together.
PoseCovariance of_odometry() {
  PoseCovariance covariance = PoseCovariance::Zero();
  covariance(0, 0) = 0.1 * 0.1;
  covariance(1, 1) = 0.03 * 0.03;
  covariance(5, 5) = 0.02 * 0.02;
  covariance(1, 5) = covariance(5, 1) = 0.5 * 0.03 * 0.02;
  return covariance;
}

/// Where the robot believes to be: off by a draw from that covariance, along its own axes.
Pose believed(const Pose& T_map_robot, Dice& dice) {
  const double y = dice.normal(0.03);
  const double heading = 0.5 * 0.02 / 0.03 * y + dice.normal(0.02 * std::sqrt(0.75));
  return T_map_robot * planar_pose(dice.normal(0.1), y, heading);
}

/// The squared Mahalanobis distance of a landmark from where it is mapped, by a robot that passes
/// it with a pose that errs anew each time.
double nees(StatedCovariance stated, std::uint32_t seed) {
  Dice dice(seed);
  LandmarkOptions options;
  options.pose.stated = stated;
  options.wrong.huber = 100.0;  // all errors are Gaussian here
  LandmarkMapper mapper(options);
  const Eigen::Vector3d landmark(dice.uniform(3.0, 5.0), dice.uniform(-1.0, 1.0), 0.0);
  for (int step = 0; step < kSteps; ++step) {
    const Pose T = planar_pose(0.02 * step, 2.0 - 0.1 * step, 1.0 - 0.05 * step);
    const Eigen::Vector2d z = PolarModel::h(T.inverse() * landmark);
    LandmarkSighting sighting;
    sighting.id = 1;
    sighting.range_stddev = 0.05;
    sighting.azimuth_stddev = 0.01;
    sighting.range = z[0] + dice.normal(sighting.range_stddev);
    sighting.azimuth = z[1] + dice.normal(sighting.azimuth_stddev);
    mapper.insert(LandmarkSightings{{sighting}, of_odometry()}, believed(T, dice));
  }
  const LandmarkEstimate estimate = mapper.estimates().at(0);
  const Eigen::Vector2d error = (landmark - estimate.mean).head<2>();
  const Eigen::Matrix2d covariance = estimate.covariance.topLeftCorner<2, 2>();
  return error.dot(covariance.ldlt().solve(error));
}

double nees_of_all_runs(StatedCovariance stated) {
  double sum = 0.0;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) sum += nees(stated, seed);
  return sum;
}

TEST(LandmarkPoseUncertainty, IsHonestWhereOdometryStatesHowVagueItIs) {
  const double sum = nees_of_all_runs(StatedCovariance::used);
  EXPECT_GT(sum, chi_squared_quantile(0.005, kDegrees)) << "over-cautious";
  EXPECT_LT(sum, chi_squared_quantile(0.995, kDegrees)) << "over-confident";
}

TEST(LandmarkPoseUncertainty, IsOverConfidentWhereThatIsIgnored) {
  EXPECT_GT(nees_of_all_runs(StatedCovariance::ignored),
            2.0 * chi_squared_quantile(0.995, kDegrees));
}

TEST(LandmarkPoseUncertainty, OfTheOptionsAndOfOdometryAddUp) {
  LandmarkPoseOptions options;
  options.position_stddev = 0.2;
  options.heading_stddev = 0.1;
  options.stated = StatedCovariance::used;
  const Pose T = planar_pose(1.0, 2.0, 0.5 * M_PI);
  const UncertainSensorPose both = uncertain(T, of_odometry(), options);
  EXPECT_NEAR(both.covariance(0, 0), 0.04 + 0.0009, 1e-9) << "the robot's y";
  EXPECT_NEAR(both.covariance(1, 1), 0.04 + 0.01, 1e-9);
  EXPECT_NEAR(both.covariance(5, 5), 0.01 + 0.0004, 1e-9);
  EXPECT_TRUE(uncertain(T, PoseCovariance::Zero(), {}).is_certain);
}

}  // namespace
}  // namespace portolan
