// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/polar.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beacon/scenario.hpp"
#include "portolan/beacon/inverse_range.hpp"
#include "portolan/testing/numeric_jacobian.hpp"

namespace portolan {
namespace {

using beacon_test::Dice;

// The Gaussian of Figure 12: 9 m, 45 degrees, deviations of 0.2 m and 50 degrees.
Hypothesis figure_12() {
  Hypothesis h;
  h.is_polar = true;
  h.x = {9.0, M_PI / 4.0, 0.0};
  h.Q.diagonal() << 0.2 * 0.2, std::pow(50.0 / 180.0 * M_PI, 2), 0.0;
  return h;
}

struct Moments {
  double weight = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

Moments moments(const std::vector<Hypothesis>& hypotheses) {
  Moments m;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Hypothesis& h : hypotheses) {
    m.weight += h.weight;
    m.mean += h.weight * h.x;
    squares += h.weight * (h.Q + h.x * h.x.transpose());
  }
  m.covariance = squares - m.mean * m.mean.transpose();
  return m;
}

TEST(Polar, JacobianIsTheDerivative) {
  Dice dice(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d polar(dice.uniform(1.0, 20.0), dice.normal(2.0), dice.uniform(-1.2, 1.2));
    const auto place = [](const Eigen::Vector3d& x) {
      return from_polar(x, Eigen::Vector3d(1.0, 2.0, 3.0));
    };
    EXPECT_LT((polar_jacobian(polar) - testing::numeric_jacobian(place, polar)).norm(), 1e-6);
  }
}

TEST(Polar, SplittingKeepsWeightMeanAndCovariance) {
  std::vector<Hypothesis> hypotheses{figure_12()};
  const Moments before = moments(hypotheses);
  split_polar({3.0, 0.0, 0.0}, 0.2, Eigen::Vector3d::Zero(), RangeCalibration{}, 2000, hypotheses);
  EXPECT_GT(hypotheses.size(), 8u);
  const Moments after = moments(hypotheses);
  EXPECT_NEAR(after.weight, before.weight, 1e-6);
  EXPECT_LT((after.mean - before.mean).norm(), 1e-6);
  EXPECT_LT((after.covariance - before.covariance).norm(), 0.02 * before.covariance.norm());
}

TEST(Polar, WhereTheAntennaHasNotMovedNothingIsSplit) {
  std::vector<Hypothesis> hypotheses{figure_12()};
  split_polar(Eigen::Vector3d::Zero(), 0.2, Eigen::Vector3d::Zero(), RangeCalibration{}, 2000,
              hypotheses);
  EXPECT_EQ(hypotheses.size(), 1u);
}

TEST(Polar, SplittingStopsAtTheCap) {
  std::vector<Hypothesis> hypotheses{figure_12()};
  split_polar({5.0, 0.0, 0.0}, 0.001, Eigen::Vector3d::Zero(), RangeCalibration{}, 50, hypotheses);
  EXPECT_LE(hypotheses.size(), 50u);
}

TEST(Polar, StraightenedPiecesLieOnTheRing) {
  std::vector<Hypothesis> pieces;
  const Eigen::Vector3d origin(1.0, 1.0, 0.0);
  append_straightened(figure_12(), origin, RangeCalibration{}, pieces);
  EXPECT_GT(pieces.size(), 8u);
  double weight = 0.0;
  for (const Hypothesis& h : pieces) {
    EXPECT_FALSE(h.is_polar);
    EXPECT_NEAR((h.x - origin).norm(), 9.0, 1e-9);
    weight += h.weight;
  }
  EXPECT_NEAR(weight, 1.0, 1e-6);
}

TEST(Polar, UnscentedDistanceHasTheMomentsOfSamples) {
  Dice dice(8);
  Hypothesis h = figure_12();
  h.Q(1, 1) = 0.04;
  h.Q(2, 2) = 0.03;
  const Eigen::Vector3d p_map(4.0, -2.0, 1.0);
  double sum = 0.0;
  double squares = 0.0;
  const int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector3d x =
        h.x + Eigen::Vector3d(dice.normal(0.2), dice.normal(0.2), dice.normal(std::sqrt(0.03)));
    const double distance = (from_polar(x, Eigen::Vector3d::Zero()) - p_map).norm();
    sum += distance;
    squares += distance * distance;
  }
  const double mean = sum / samples;
  const DistancePrediction d = predict_distance_polar(h.x, h.Q, Eigen::Vector3d::Zero(), p_map);
  EXPECT_NEAR(d.mean, mean, 0.01);
  EXPECT_NEAR(d.variance, squares / samples - mean * mean, 0.04);
}

TEST(Polar, FourWideGaussiansMakeAnEvenRing) {
  BeaconOptions options = beacon_test::calibrated();
  PosedRange z;
  z.range = 9.0;
  z.stddev = 0.2;
  std::vector<Hypothesis> modes;
  inverse_range_polar(z, RangeCalibration{}, options, modes);
  ASSERT_EQ(modes.size(), 4u);
  double least = 1e9;
  double most = 0.0;
  for (int i = 0; i < 360; ++i) {
    double density = 0.0;
    for (const Hypothesis& mode : modes) {
      const double off = wrap_angle(i / 180.0 * M_PI - mode.x[1]);
      for (int turn = -2; turn <= 2; ++turn) {
        density +=
            mode.weight * std::exp(-0.5 * std::pow(off + 2.0 * M_PI * turn, 2) / mode.Q(1, 1));
      }
    }
    least = std::min(least, density);
    most = std::max(most, density);
  }
  EXPECT_LT(most / least, 1.02);
}

}  // namespace
}  // namespace portolan
