// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/place_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "landmark/dice.hpp"
#include "landmark/plain_filter.hpp"
#include "portolan/landmark/inverse_depth.hpp"
#include "portolan/testing/numeric_jacobian.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;
using landmark_test::PlainFilter;
using landmark_test::SixFilter;

Measured<PolarModel> polar(double range, double azimuth) {
  return {{}, {range, azimuth}, {0.1 * 0.1, 0.02 * 0.02}};
}

Measured<DirectionModel> direction(double azimuth, double elevation) {
  return {{}, {azimuth, elevation}, {1e-4, 1e-4}};
}

Measured<DirectionModel> direction_to(const Eigen::Vector3d& p_map, const Pose& T_map_sensor) {
  const Eigen::Vector2d angles = DirectionModel::h(T_map_sensor.inverse() * p_map);
  return direction(angles[0], angles[1]);
}

UncertainSensorPose at(const Pose& T_map_sensor) { return UncertainSensorPose{T_map_sensor}; }

UncertainSensorPose at(double x, double y, double z = 0.0) {
  Pose pose = planar_pose(x, y, 0.2);
  pose.translation().z() = z;
  return at(pose);
}

void expect_covariance(const Eigen::Matrix3d& covariance) {
  EXPECT_EQ(covariance, covariance.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
}

TEST(PlaceFilter, InThePlaneIsTheChaptersFilter) {
  Dice dice(1);
  const Eigen::Vector3d landmark(3.0, -2.0, 0.0);
  const Eigen::Matrix2d R = Eigen::Vector2d(0.1 * 0.1, 0.02 * 0.02).asDiagonal();
  PlainFilter plain;
  Place place;
  for (int i = 0; i < 30; ++i) {
    const Pose T =
        planar_pose(dice.uniform(-2.0, 2.0), dice.uniform(-1.0, 2.0), dice.uniform(-3.0, 3.0));
    Eigen::Vector2d z = PolarModel::h(T.inverse() * landmark);
    z += Eigen::Vector2d(dice.normal(0.1), dice.normal(0.02));
    plain.take(z[0], z[1], T, R);
    if (i == 0) {
      place = first_place(polar(z[0], z[1]), at(T), LandmarkOptions{});
    } else {
      update(place, polar(z[0], z[1]), at(T), 1.0, LandmarkOptions{});
    }
    EXPECT_LT((place.mean.head<2>() - plain.mean).norm(), 1e-9);
    const Eigen::Matrix2d flat = place.covariance.topLeftCorner<2, 2>();
    EXPECT_LT((flat - plain.covariance).norm(), 1e-12);
    expect_covariance(place.covariance);
  }
  EXPECT_EQ(place.mean.z(), 0.0);
}

// The three coordinates that the filter carries are those of all six that an exact pose leaves.
TEST(PlaceFilter, ThreeCoordinatesOfARayAreAsGoodAsSix) {
  const Eigen::Vector3d landmark(6.0, 1.0, 0.8);
  LandmarkOptions options;
  options.unmeasured.linearity = 1e-9;
  Place place =
      first_place(direction_to(landmark, Pose::Identity()), at(Pose::Identity()), options);
  SixFilter six;
  six.mean << 0.0, 0.0, 0.0, DirectionModel::h(landmark), place.mean[2];
  six.covariance.setZero();
  six.covariance.diagonal().tail<3>() << 1e-4, 1e-4, place.covariance(2, 2);
  Dice dice(2);
  for (int i = 1; i < 12; ++i) {
    const Pose T = at(0.0, 0.25 * i).T_map_sensor;
    Measured<DirectionModel> z = direction_to(landmark, T);
    z.z += Eigen::Vector2d(dice.normal(0.002), dice.normal(0.002));
    update(place, z, at(T), 1.0, options);
    const auto h = [&](const Eigen::Matrix<double, 6, 1>& m) {
      return DirectionModel::h(T.inverse() * SixFilter::point(m));
    };
    const SixFilter prior = six;
    for (int iteration = 0; iteration < 4; ++iteration) {
      const Eigen::Matrix<double, 2, 6> H = testing::numeric_jacobian(h, six.mean);
      const Eigen::Matrix2d S =
          H * prior.covariance * H.transpose() + 1e-4 * Eigen::Matrix2d::Identity();
      const Eigen::Matrix<double, 6, 2> K = prior.covariance * H.transpose() * S.inverse();
      six.mean = prior.mean + K * (z.z - h(six.mean) + H * (six.mean - prior.mean));
      six.covariance = (Eigen::Matrix<double, 6, 6>::Identity() - K * H) * prior.covariance;
    }
    EXPECT_NEAR(place.mean[2], six.mean[5], 1e-4);
    EXPECT_NEAR(place.covariance(2, 2), six.covariance(5, 5), 1e-3 * six.covariance(5, 5));
  }
  EXPECT_EQ(place.form, PlaceForm::ray);
  EXPECT_LT((as_point(place, 100.0).mean - landmark).norm(), 0.2);
}

TEST(PlaceFilter, FirstRayReachesFromTheNearestDepthToTheFurthest) {
  LandmarkOptions options;
  options.unmeasured.min_depth = 0.5;
  options.unmeasured.max_depth = 20.0;
  const Place ray = first_place(direction(0.3, 0.1), at(1.0, 2.0), options);
  const double deviation = std::sqrt(ray.covariance(2, 2));
  EXPECT_NEAR(1.0 / (ray.mean[2] + 3.0 * deviation), 0.5, 1e-9);
  EXPECT_NEAR(1.0 / (ray.mean[2] - 3.0 * deviation), 20.0, 1e-9);
}

TEST(PlaceFilter, ParallaxMakesAPointOfARay) {
  for (const LandmarkFilter filter : {LandmarkFilter::ekf, LandmarkFilter::ukf}) {
    LandmarkOptions options;
    options.filter = filter;
    const Eigen::Vector3d landmark(4.0, 1.0, 0.5);
    Place place =
        first_place(direction_to(landmark, at(0.0, 0.0).T_map_sensor), at(0.0, 0.0), options);
    for (int i = 1; i <= 60; ++i) {
      const UncertainSensorPose sensor = at(0.02 * i, -0.05 * i, 0.01 * i);
      update(place, direction_to(landmark, sensor.T_map_sensor), sensor, 1.0, options);
    }
    EXPECT_EQ(place.form, PlaceForm::point);
    EXPECT_LT((place.mean - landmark).norm(), 0.05);
    expect_covariance(place.covariance);
  }
}

TEST(PlaceFilter, WithoutParallaxItStaysARay) {
  const LandmarkOptions options;
  const Eigen::Vector3d landmark(8.0, 0.0, 0.0);
  Place place =
      first_place(direction_to(landmark, Pose::Identity()), at(Pose::Identity()), options);
  for (int i = 1; i < 50; ++i) {
    const UncertainSensorPose sensor = at(planar_pose(0.05 * i, 0.0, 0.0));
    update(place, direction_to(landmark, sensor.T_map_sensor), sensor, 1.0, options);
  }
  EXPECT_EQ(place.form, PlaceForm::ray);
}

TEST(PlaceFilter, WhatIsAtInfinityStaysADirection) {
  const LandmarkOptions options;
  const Eigen::Vector3d star(1e7, 2e6, 5e6);
  Dice dice(3);
  Place place = first_place(direction_to(star, at(0.0, 0.0).T_map_sensor), at(0.0, 0.0), options);
  int behind = 0;
  for (int i = 1; i < 400; ++i) {
    const UncertainSensorPose sensor = at(0.01 * i, 2.0 * std::sin(0.02 * i));
    Measured<DirectionModel> z = direction_to(star, sensor.T_map_sensor);
    z.z += Eigen::Vector2d(dice.normal(0.01), dice.normal(0.01));
    update(place, z, sensor, 1.0, options);
    behind += place.mean[2] < 0.0;
    EXPECT_TRUE(place.mean.allFinite());
  }
  EXPECT_GT(behind, 0);  // inverse depth below 0 does no harm
  EXPECT_EQ(place.form, PlaceForm::ray);
  EXPECT_FALSE(has_depth(place, options.unmeasured.max_depth));
  EXPECT_LT(std::abs(place.mean[2]), 3.0 * std::sqrt(place.covariance(2, 2)));
  const Eigen::Vector3d point = as_point(place, options.unmeasured.max_depth).mean;
  EXPECT_GT(point.normalized().dot(star.normalized()), 0.999);
}

TEST(PlaceFilter, ARangeMakesAPointOfARay) {
  const LandmarkOptions options;
  const Eigen::Vector3d landmark(3.0, 1.0, 0.5);
  const UncertainSensorPose camera = at(0.0, 0.0);
  Place place = first_place(direction_to(landmark, camera.T_map_sensor), camera, options);
  const UncertainSensorPose laser = at(0.5, -0.5);
  const Eigen::Vector3d z = SphericalModel::h(laser.T_map_sensor.inverse() * landmark);
  const Measured<SphericalModel> ranged{{}, z, {1e-4, 1e-4, 1e-4}};
  ASSERT_TRUE(fit(place, ranged, laser));
  EXPECT_LT(fit(place, ranged, laser)->distance, 11.3);
  update(place, ranged, laser, 1.0, options);
  EXPECT_EQ(place.form, PlaceForm::point);
  EXPECT_LT((place.mean - landmark).norm(), 0.02);
  expect_covariance(place.covariance);
}

TEST(PlaceFilter, ACameraDoesNotSeeBehindItself) {
  Place place;
  place.mean = {0.0, 0.0, -2.0};
  const Measured<PixelModel> z{{{}, {400.0, 400.0, 320.0, 240.0}}, {320.0, 240.0}, {1.0, 1.0}};
  EXPECT_FALSE(fit(place, z, at(Pose::Identity())));
  place.mean.z() = 2.0;
  ASSERT_TRUE(fit(place, z, at(Pose::Identity())));
  EXPECT_EQ(fit(place, z, at(Pose::Identity()))->distance, 0.0);
}

TEST(PlaceFilter, AnUncertainPoseInflatesTheInnovation) {
  const LandmarkOptions options;
  const Place place = first_place(polar(5.0, 0.1), at(0.0, 0.0), options);
  LandmarkPoseOptions deviations;
  deviations.position_stddev = 0.2;
  deviations.heading_stddev = 0.05;
  const UncertainSensorPose vague = uncertain(at(0.0, 0.0).T_map_sensor, std::nullopt, deviations);
  EXPECT_LT(fit(place, polar(5.5, 0.15), vague)->distance,
            fit(place, polar(5.5, 0.15), at(0.0, 0.0))->distance);
  const Place vaguer = first_place(polar(5.0, 0.1), vague, options);
  EXPECT_NEAR(
      vaguer.covariance(0, 0) + vaguer.covariance(1, 1),
      place.covariance(0, 0) + place.covariance(1, 1) + 2.0 * 0.2 * 0.2 + 5.0 * 5.0 * 0.05 * 0.05,
      1e-9);
}

// What an exact pose and a small error of it show differs as the covariance says.
TEST(PlaceFilter, TheFirstPlaceVariesWithThePoseAsItsCovarianceSays) {
  const LandmarkOptions options;
  PoseCovariance stated = PoseCovariance::Zero();
  stated.diagonal() << 0.02, 0.04, 0.01, 1e-4, 4e-4, 9e-4;
  stated(0, 5) = stated(5, 0) = 0.002;
  LandmarkPoseOptions used;
  used.stated = StatedCovariance::used;
  const Pose T = at(1.0, 2.0, 0.5).T_map_sensor;
  const Measurement z = direction(0.4, 0.3);
  Place exact = first_place(z, at(T), options);
  Place vague = first_place(z, uncertain(T, stated, used), options);
  const PoseCovariance in_map = turned(stated, T.linear());
  Eigen::Matrix2d expected = Eigen::Matrix2d::Zero();
  const auto angles = [&](const Eigen::Matrix<double, 6, 1>& error) -> Eigen::Vector2d {
    Pose moved = T;
    moved.translation() += error.head<3>();
    moved.linear() = (Eigen::Matrix3d::Identity() + cross_matrix(error.tail<3>())) * T.linear();
    const Eigen::Vector3d p = InverseDepth::point(moved * (T.inverse() * exact.T_map_ray),
                                                  Eigen::Vector3d(0.0, 0.0, exact.mean[2]));
    return InverseDepth::from_point(exact.T_map_ray, p).head<2>();
  };
  const Eigen::Matrix<double, 6, 1> none = Eigen::Matrix<double, 6, 1>::Zero();
  const auto J = testing::numeric_jacobian(angles, none);
  expected = J * in_map * J.transpose();
  const Eigen::Matrix2d more = (vague.covariance - exact.covariance).topLeftCorner<2, 2>();
  EXPECT_LT((more - expected).norm(), 1e-6 * expected.norm());
}

TEST(PlaceFilter, LittleTrustMovesLittle) {
  const LandmarkOptions options;
  const Place first = first_place(polar(5.0, 0.1), at(0.0, 0.0), options);
  Place trusting = first;
  Place doubting = first;
  update(trusting, polar(5.5, 0.1), at(0.0, 0.0), 1.0, options);
  update(doubting, polar(5.5, 0.1), at(0.0, 0.0), 0.2, options);
  EXPECT_GT((trusting.mean - first.mean).norm(), 1.5 * (doubting.mean - first.mean).norm());
}

}  // namespace
}  // namespace portolan
