// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <string>
#include <vector>

#include "landmark/dice.hpp"
#include "portolan/landmark/chi_squared.hpp"
#include "portolan/landmark/expectation.hpp"
#include "portolan/landmark/place_filter.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;

constexpr int kRuns = 50;
constexpr int kSteps = 60;

/// A drive past one landmark, and what a sensor with Gaussian errors measures of it.
template <class Model>
struct Drive {
  explicit Drive(std::uint32_t seed) {
    Dice dice(seed);
    landmark = {dice.uniform(3.0, 5.0), dice.uniform(-1.0, 1.0),
                Model::kSize == 3 || !kPlanar ? dice.uniform(-0.5, 1.0) : 0.0};
    const typename Model::Vector stddev = deviations();
    for (int step = 0; step < kSteps; ++step) {
      Pose T = planar_pose(0.02 * step, 2.0 - 0.07 * step, 0.3 - 0.005 * step);
      if (!kPlanar) T.translation().z() = 0.2 * std::sin(0.2 * step);
      if (kOptical) T.linear() = T.linear() * optical();
      Measured<Model> z{model(), model().h(T.inverse() * landmark), stddev.cwiseAbs2()};
      for (Eigen::Index i = 0; i < stddev.size(); ++i) z.z[i] += dice.normal(stddev[i]);
      poses.push_back(T);
      measured.push_back(z);
    }
  }

  static constexpr bool kOptical = std::is_same_v<Model, PixelModel>;
  static constexpr bool kPlanar =
      std::is_same_v<Model, PolarModel> || std::is_same_v<Model, AzimuthModel>;
  static constexpr std::size_t kDegrees = kPlanar ? 2 : 3;

  static Model model() {
    if constexpr (kOptical) {
      return {{}, {400.0, 420.0, 320.0, 240.0}};
    } else {
      return {};
    }
  }
  static Eigen::Matrix3d optical() {
    return (Eigen::Matrix3d() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0).finished();
  }
  static typename Model::Vector deviations() {
    typename Model::Vector stddev = Model::Vector::Constant(kOptical ? 2.0 : 0.01);
    if (!Model::kScaleFree) stddev[0] = 0.1;
    return stddev;
  }

  Eigen::Vector3d landmark;
  std::vector<Pose> poses;
  std::vector<Measured<Model>> measured;
};

template <class Model>
Place filtered(const Drive<Model>& drive, const LandmarkOptions& options) {
  Place place = first_place(drive.measured[0], UncertainSensorPose{drive.poses[0]}, options);
  for (std::size_t i = 1; i < drive.poses.size(); ++i)
    update(place, drive.measured[i], UncertainSensorPose{drive.poses[i]}, 1.0, options);
  return place;
}

/// Least squares on all measurements at once (Gauss-Newton), from the truth.
template <class Model>
Place batch(const Drive<Model>& drive) {
  Place place;
  place.mean = drive.landmark;
  for (int iteration = 0; iteration < 10; ++iteration) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < drive.poses.size(); ++i) {
      const Measured<Model>& z = drive.measured[i];
      const auto linear = linearize_point(place.mean, z, drive.poses[i]);
      const auto weights = z.variance.cwiseInverse().asDiagonal();
      information += linear->H.transpose() * weights * linear->H;
      vector += linear->H.transpose() * weights * linear->nu;
    }
    if (Drive<Model>::kPlanar) information(2, 2) += 1.0;  // the height's own deviation
    place.mean += information.ldlt().solve(vector);
    place.covariance = information.inverse();
  }
  return place;
}

double nees(const Place& place, const Eigen::Vector3d& truth, std::size_t degrees) {
  const auto size = static_cast<Eigen::Index>(degrees);
  const Eigen::VectorXd error = (truth - place.mean).head(size);
  return error.dot(place.covariance.topLeftCorner(size, size).ldlt().solve(error));
}

template <class Model>
class LandmarkConsistency : public ::testing::Test {};
using Models =
    ::testing::Types<PolarModel, SphericalModel, AzimuthModel, DirectionModel, PixelModel>;
TYPED_TEST_SUITE(LandmarkConsistency, Models, );

TYPED_TEST(LandmarkConsistency, NeesIsChiSquaredOverFiftyRuns) {
  for (const LandmarkFilter filter : {LandmarkFilter::ekf, LandmarkFilter::ukf}) {
    LandmarkOptions options;
    options.filter = filter;
    double sum = 0.0;
    for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
      const Drive<TypeParam> drive(seed);
      const Place place = filtered(drive, options);
      ASSERT_EQ(place.form, PlaceForm::point) << "seed " << seed;
      sum += nees(place, drive.landmark, Drive<TypeParam>::kDegrees);
    }
    constexpr std::size_t kDegrees = kRuns * Drive<TypeParam>::kDegrees;
    EXPECT_GT(sum, chi_squared_quantile(0.005, kDegrees)) << "over-cautious";
    EXPECT_LT(sum, chi_squared_quantile(0.995, kDegrees)) << "over-confident";
  }
}

TYPED_TEST(LandmarkConsistency, TheFilterEndsWhereBatchLeastSquaresDoes) {
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    const Drive<TypeParam> drive(seed);
    const Place recursive = filtered(drive, LandmarkOptions{});
    const Place at_once = batch(drive);
    const std::size_t degrees = Drive<TypeParam>::kDegrees;
    // Apart by less than a deviation of the estimate, and as certain as it to within a tenth.
    EXPECT_LT(nees(at_once, recursive.mean, degrees), 1.0) << "seed " << seed;
    const auto size = static_cast<Eigen::Index>(degrees);
    const double ratio = recursive.covariance.topLeftCorner(size, size).trace() /
                         at_once.covariance.topLeftCorner(size, size).trace();
    EXPECT_NEAR(ratio, 1.0, 0.2) << "seed " << seed;
  }
}

}  // namespace
}  // namespace portolan
