// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/inverse_range.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "beacon/scenario.hpp"

namespace portolan {
namespace {

double density(const std::vector<Hypothesis>& modes, const Eigen::Vector2d& p) {
  double sum = 0.0;
  for (const Hypothesis& mode : modes) {
    const Eigen::Matrix2d Q = mode.Q.topLeftCorner<2, 2>();
    const Eigen::Vector2d step = p - mode.x.head<2>();
    sum += mode.weight * std::exp(-0.5 * step.dot(Q.inverse() * step)) /
           (2.0 * M_PI * std::sqrt(Q.determinant()));
  }
  return sum;
}

// Total variation between the mixture and Eq. 37 as a density over the plane, both symmetric
// enough about the antenna to be compared over the sector of a few modes.
double ring_error(double range, double stddev, const BeaconOptions& options) {
  PosedRange z;
  z.range = range;
  z.stddev = stddev;
  std::vector<Hypothesis> modes;
  inverse_range(z, RangeCalibration{}, options, modes);
  const double sector = 2.0 * M_PI / static_cast<double>(modes.size());
  const double normalizer = std::sqrt(2.0 * M_PI) * stddev * range * sector;
  double error = 0.0;
  double mass = 0.0;
  const int cells = 60;
  for (int i = 0; i < cells; ++i) {
    const double azimuth = sector * (i + 0.5) / cells;
    for (int j = 0; j < 4 * cells; ++j) {
      const double r = range + 8.0 * stddev * ((j + 0.5) / (4 * cells) - 0.5) * 2.0;
      const double area = r * (sector / cells) * (16.0 * stddev / (4 * cells));
      const double u = (r - range) / stddev;
      const double exact = std::exp(-0.5 * u * u) / normalizer;
      const double ours =
          density(modes, r * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth))) *
          static_cast<double>(modes.size());
      error += 0.5 * std::abs(exact - ours) * area;
      mass += exact * area;
    }
  }
  EXPECT_NEAR(mass, 1.0, 1e-3);
  return error;
}

TEST(InverseRange, RingIsWithinItsStatedErrorOfTheTrueRing) {
  const BeaconOptions options = beacon_test::calibrated();
  for (const double stddev : {0.01, 0.1, 0.5}) {
    for (const double in_deviations : {10.0, 30.0, 100.0, 300.0}) {
      EXPECT_LT(ring_error(in_deviations * stddev, stddev, options), 0.03)
          << "range " << in_deviations << " times " << stddev;
    }
  }
}

TEST(InverseRange, TooFewModesMakeALumpierRing) {
  BeaconOptions few = beacon_test::calibrated();
  few.max_modes = 12;
  EXPECT_GT(ring_error(10.0, 0.1, few), 0.03);
}

TEST(InverseRange, ModesSumToOneAndKeepToThePlane) {
  PosedRange z;
  z.p_map = {1.0, 2.0, 0.0};
  z.range = 5.0;
  std::vector<Hypothesis> modes;
  inverse_range(z, RangeCalibration{}, beacon_test::calibrated(), modes);
  double total = 0.0;
  for (const Hypothesis& mode : modes) {
    total += mode.weight;
    EXPECT_EQ(mode.x.z(), 0.0);
    EXPECT_EQ(mode.Q.row(2).norm(), 0.0);
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
}

TEST(InverseRange, AHeightDifferenceShrinksTheRing) {
  BeaconOptions options = beacon_test::calibrated();
  options.height = 3.0;
  PosedRange z;
  z.p_map = {0.0, 0.0, -3.0};
  z.range = 5.0;
  z.stddev = 0.02;
  std::vector<Hypothesis> modes;
  inverse_range(z, RangeCalibration{}, options, modes);
  for (const Hypothesis& mode : modes) EXPECT_NEAR(mode.x.norm(), 4.0, 0.02);
}

TEST(InverseRange, BelowABeaconThereIsOneBlob) {
  BeaconOptions options = beacon_test::calibrated();
  options.height = 3.0;
  PosedRange z;
  z.p_map = {0.0, 0.0, -3.0};
  z.range = 2.95;
  z.stddev = 0.1;
  std::vector<Hypothesis> modes;
  inverse_range(z, RangeCalibration{}, options, modes);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].x.norm(), 0.0, 1e-12);
}

TEST(InverseRange, ShellKeepsToItsElevations) {
  BeaconOptions options = beacon_test::calibrated();
  options.space = BeaconSpace::spatial;
  options.elevation_min = 0.1;
  options.elevation_max = 0.6;
  PosedRange z;
  z.p_map = {1.0, -1.0, 0.5};
  z.range = 6.0;
  std::vector<Hypothesis> modes;
  inverse_range(z, RangeCalibration{}, options, modes);
  double total = 0.0;
  for (const Hypothesis& mode : modes) {
    const Eigen::Vector3d v = mode.x - z.p_map;
    const double elevation = std::asin(v.z() / v.norm());
    EXPECT_GT(elevation, 0.1);
    EXPECT_LT(elevation, 0.6);
    EXPECT_NEAR(v.norm(), 6.0, 0.05);
    total += mode.weight;
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
  EXPECT_GT(modes.size(), 50u);
  EXPECT_LE(modes.size(), options.max_modes);
}

TEST(InverseRange, AnUncertainCalibrationStretchesTheRing) {
  RangeCalibration c;
  c.covariance = Eigen::Vector3d(0.05 * 0.05, 0.1 * 0.1, 0.0).asDiagonal();
  PosedRange z;
  z.range = 10.0;
  z.stddev = 0.1;
  std::vector<Hypothesis> modes;
  inverse_range(z, c, beacon_test::calibrated(), modes);
  const double along = modes[0].covariance(c)(0, 0);
  EXPECT_NEAR(along, 0.1 * 0.1 + 0.5 * 0.5 + 0.1 * 0.1, 0.01);
}

}  // namespace
}  // namespace portolan
