// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "landmark/dice.hpp"
#include "portolan/landmark/expectation.hpp"
#include "portolan/landmark/inverse_depth.hpp"
#include "portolan/landmark/inverse_sensor_model.hpp"
#include "portolan/landmark/sensor_models.hpp"
#include "portolan/testing/numeric_jacobian.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;
using testing::numeric_jacobian;

constexpr double kClose = 1e-6;
constexpr int kDraws = 50;

/// A model with a camera where it needs one.
template <class Model>
Model model() {
  return {};
}
template <>
PixelModel model<PixelModel>() {
  return {{}, {400.0, 420.0, 320.0, 240.0}};
}

template <class Derived, class Other>
void expect_close(const Eigen::MatrixBase<Derived>& ours, const Eigen::MatrixBase<Other>& numeric) {
  EXPECT_LT((ours - numeric).norm(), kClose * (1.0 + numeric.norm())) << "ours\n"
                                                                      << ours << "\nnumeric\n"
                                                                      << numeric;
}

/// A ray, a sensor that sees where it ends, and what that sensor measures.
struct Scene {
  explicit Scene(Dice& dice) {
    ray.form = PlaceForm::ray;
    ray.T_map_ray = dice.pose(2.0);
    ray.mean = {dice.uniform(-0.4, 0.4), dice.uniform(-0.4, 0.4), dice.uniform(0.1, 0.5)};
    p_map = InverseDepth::point(ray.T_map_ray, ray.mean);
    T_map_sensor = dice.pose(1.0);
    // Turned so that the point lies ahead of a camera and off the poles of the angles.
    const Eigen::Vector3d l = T_map_sensor.inverse() * p_map;
    const Eigen::Vector3d ahead = Eigen::Vector3d(0.5, 0.3, 1.0);
    T_map_sensor.rotate(Eigen::Quaterniond::FromTwoVectors(ahead, l));
  }
  Place ray;
  Eigen::Vector3d p_map;
  Pose T_map_sensor;
};

/// The sensor's pose after a small step along the map's axes and a small turn about its z axis.
using PoseError = Eigen::Matrix<double, 6, 1>;

Pose disturbed(const Pose& T_map_sensor, const PoseError& error) {
  Pose pose = T_map_sensor;
  pose.translation() += error.head<3>();
  const double angle = error.tail<3>().norm();
  const Eigen::Vector3d axis = error.tail<3>().stableNormalized();
  if (angle > 0.0) pose.linear() = Eigen::AngleAxisd(angle, axis) * T_map_sensor.linear();
  return pose;
}

template <class Model>
class LandmarkJacobians : public ::testing::Test {};
using Models =
    ::testing::Types<PolarModel, SphericalModel, AzimuthModel, DirectionModel, PixelModel>;
TYPED_TEST_SUITE(LandmarkJacobians, Models, );

TYPED_TEST(LandmarkJacobians, OfTheSensorModelByThePointItSees) {
  Dice dice(1);
  const TypeParam m = model<TypeParam>();
  for (int i = 0; i < kDraws; ++i) {
    Eigen::Vector3d l = dice.point(5.0);
    l.z() = std::abs(l.z()) + 0.5;
    const auto h = [&](const Eigen::Vector3d& p) { return m.h(p); };
    expect_close(m.H(l), numeric_jacobian(h, l, &TypeParam::difference));
  }
}

TYPED_TEST(LandmarkJacobians, ScaleFreeModelsMeasureDirections) {
  const TypeParam m = model<TypeParam>();
  const Eigen::Vector3d l(1.0, 2.0, 3.0);
  EXPECT_EQ((m.h(l) - m.h(2.0 * l)).norm() < 1e-12, TypeParam::kScaleFree);
}

TYPED_TEST(LandmarkJacobians, OfAPointByItsCoordinatesAndByThePose) {
  Dice dice(2);
  for (int i = 0; i < kDraws; ++i) {
    const Scene scene(dice);
    const TypeParam m = model<TypeParam>();
    const auto expected = [&](const Eigen::Vector3d& p, const Pose& T) {
      return m.h(T.inverse() * p);
    };
    const Measured<TypeParam> z{m, expected(scene.p_map, scene.T_map_sensor),
                                TypeParam::Vector::Ones()};
    const auto linear = linearize_point(scene.p_map, z, scene.T_map_sensor);
    ASSERT_TRUE(linear);
    EXPECT_LT(linear->nu.norm(), 1e-9);
    const auto by_p = [&](const Eigen::Vector3d& p) { return expected(p, scene.T_map_sensor); };
    expect_close(linear->H, numeric_jacobian(by_p, scene.p_map, &TypeParam::difference));
    const auto by_error = [&](const PoseError& error) {
      return expected(scene.p_map, disturbed(scene.T_map_sensor, error));
    };
    const PoseError none = PoseError::Zero();
    expect_close(by_pose(*linear), numeric_jacobian(by_error, none, &TypeParam::difference));
  }
}

TYPED_TEST(LandmarkJacobians, OfARayByItsCoordinatesAndByThePose) {
  Dice dice(3);
  for (int i = 0; i < kDraws; ++i) {
    const Scene scene(dice);
    const TypeParam m = model<TypeParam>();
    const auto expected = [&](const Eigen::Vector3d& x, const Pose& T) {
      return m.h(T.inverse() * InverseDepth::point(scene.ray.T_map_ray, x));
    };
    const Measured<TypeParam> z{m, expected(scene.ray.mean, scene.T_map_sensor),
                                TypeParam::Vector::Ones()};
    auto linear = linearize(scene.ray, z, scene.T_map_sensor);
    if constexpr (!TypeParam::kScaleFree)
      linear = linearize_ray_at(scene.p_map, scene.ray, z, scene.T_map_sensor);
    ASSERT_TRUE(linear);
    EXPECT_LT(linear->nu.norm(), 1e-9);
    const auto by_x = [&](const Eigen::Vector3d& x) { return expected(x, scene.T_map_sensor); };
    expect_close(linear->H, numeric_jacobian(by_x, scene.ray.mean, &TypeParam::difference));
    const auto by_error = [&](const PoseError& error) {
      return expected(scene.ray.mean, disturbed(scene.T_map_sensor, error));
    };
    const PoseError none = PoseError::Zero();
    expect_close(by_pose(*linear), numeric_jacobian(by_error, none, &TypeParam::difference));
  }
}

TEST(InverseDepthJacobians, AgreeWithNumericOnes) {
  Dice dice(4);
  for (int i = 0; i < kDraws; ++i) {
    const Scene scene(dice);
    const Pose& T = scene.ray.T_map_ray;
    const Eigen::Vector3d& x = scene.ray.mean;
    const auto direction = [](const Eigen::Vector3d& y) { return InverseDepth::direction(y); };
    expect_close(InverseDepth::direction_by_angles(x),
                 numeric_jacobian(direction, x).template leftCols<2>());
    const auto point = [&](const Eigen::Vector3d& y) { return InverseDepth::point(T, y); };
    expect_close(InverseDepth::point_by_x(T, x), numeric_jacobian(point, x));
    const auto scaled = [&](const Eigen::Vector3d& y) {
      return InverseDepth::scaled_in_sensor(T, y, scene.T_map_sensor);
    };
    expect_close(InverseDepth::scaled_in_sensor_by_x(T, x, scene.T_map_sensor),
                 numeric_jacobian(scaled, x));
    const auto from = [&](const Eigen::Vector3d& p) { return InverseDepth::from_point(T, p); };
    expect_close(InverseDepth::from_point_by_p(T, scene.p_map),
                 numeric_jacobian(from, scene.p_map));
  }
}

TEST(InverseDepth, CoordinatesGoThereAndBack) {
  Dice dice(5);
  for (int i = 0; i < kDraws; ++i) {
    const Scene scene(dice);
    const Eigen::Vector3d x = InverseDepth::from_point(scene.ray.T_map_ray, scene.p_map);
    EXPECT_LT((x - scene.ray.mean).norm(), 1e-12);
  }
}

// Eq. 27 decided by a round trip: the landmark that a sensor shows lies where the map has it.
TEST(InverseDepth, ThePointInTheSensorTimesRhoIsTheScaledOne) {
  Dice dice(6);
  for (int i = 0; i < kDraws; ++i) {
    const Scene scene(dice);
    const Eigen::Vector3d l = scene.T_map_sensor.inverse() * scene.p_map;
    const Eigen::Vector3d scaled =
        InverseDepth::scaled_in_sensor(scene.ray.T_map_ray, scene.ray.mean, scene.T_map_sensor);
    EXPECT_LT((scene.ray.mean[2] * l - scaled).norm(), 1e-12);
  }
}

TEST(InverseSensorModelJacobians, AgreeWithNumericOnes) {
  Dice dice(7);
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d z(dice.uniform(0.5, 9.0), dice.uniform(-3.0, 3.0),
                            dice.uniform(-1.4, 1.4));
    const auto spherical = [](const Eigen::Vector3d& y) { return inverse_spherical(y); };
    expect_close(inverse_spherical_by_z(z), numeric_jacobian(spherical, z));
    const auto polar = [](const Eigen::Vector3d& y) { return inverse_polar(y); };
    expect_close(inverse_polar_by_z(z), numeric_jacobian(polar, z));
    EXPECT_LT((SphericalModel::h(inverse_spherical(z)) - z).norm(), 1e-12);
    EXPECT_LT((PolarModel::h(inverse_polar(z)) - z.head<2>()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace portolan
