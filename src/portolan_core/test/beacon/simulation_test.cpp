// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {
namespace {

using beacon_test::Dice;

constexpr int kRuns = 30;
constexpr int kBeacons = 8;

struct Claim {
  double weight;
  bool is_true;
};

struct Scores {
  std::vector<double> errors;  // of the strongest modes at the end [m]
  std::vector<double> nees;
  std::vector<Claim> claims;  // every place above 2 %, on the way
  int strongest_is_true = 0;
};

bool holds(const BeaconMode& mode, const Eigen::Vector3d& truth) {
  const Eigen::Vector2d step = (truth - mode.mean).head<2>();
  return step.dot(mode.covariance.topLeftCorner<2, 2>().inverse() * step) < 13.8;  // 99.9 %
}

bool overlap(const BeaconMode& a, const BeaconMode& b) {
  const Eigen::Vector2d step = (a.mean - b.mean).head<2>();
  const Eigen::Matrix2d P = (a.covariance + b.covariance).topLeftCorner<2, 2>();
  return step.dot(P.inverse() * step) < 9.0;
}

// Modes that overlap claim one place together: the truth may well be within each of them.
void note_claims(BeaconEstimate estimate, const Eigen::Vector3d& truth, Scores& scores) {
  std::vector<BeaconMode>& left = estimate.modes;  // heaviest first
  while (!left.empty()) {
    const BeaconMode heaviest = left.front();
    Claim claim{0.0, false};
    const auto belongs = [&](const BeaconMode& mode) {
      if (!overlap(heaviest, mode)) return false;
      claim.weight += mode.weight;
      claim.is_true |= holds(mode, truth);
      return true;
    };
    std::vector<BeaconMode> others;
    for (const BeaconMode& mode : left) {
      if (!belongs(mode)) others.push_back(mode);
    }
    if (claim.weight > 0.02) scores.claims.push_back(claim);
    left = others;
  }
}

void note_end(const BeaconEstimate& estimate, const Eigen::Vector3d& truth, Scores& scores) {
  const BeaconMode& best = estimate.modes[0];
  const Eigen::Vector2d step = (truth - best.mean).head<2>();
  scores.errors.push_back(step.norm());
  scores.nees.push_back(step.dot(best.covariance.topLeftCorner<2, 2>().inverse() * step));
  scores.strongest_is_true += holds(best, truth);
}

// A robot wanders among eight beacons, hears those within 12 m, one range in twenty wrong.
void run(std::uint32_t seed, const BeaconOptions& options, double scale, double bias,
         Scores& scores) {
  Dice dice(seed);
  std::vector<Eigen::Vector3d> truth;
  truth.reserve(kBeacons);
  for (int i = 0; i < kBeacons; ++i) {
    truth.emplace_back(dice.uniform(-8.0, 8.0), dice.uniform(-8.0, 8.0), 0.0);
  }
  BeaconMapper mapper(options);
  double heading = dice.uniform(-M_PI, M_PI);
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (int step = 0; step < 150; ++step) {
    const double homewards = std::sin(heading - std::atan2(-p.y(), -p.x()));
    if (step >= 20) heading += dice.uniform(-0.3, 0.3) - 0.05 * homewards;
    p += 0.2 * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0);
    BeaconRanges z;
    for (int i = 0; i < kBeacons; ++i) {
      const double distance = (truth[static_cast<std::size_t>(i)] - p).norm();
      double range = scale * distance + bias + dice.normal(0.1);
      if (dice.uniform(0.0, 1.0) < 0.05) range += dice.uniform(0.5, 6.0);
      if (distance < 12.0) z.ranges.push_back({static_cast<BeaconId>(i), range, 0.1});
    }
    mapper.insert(z, beacon_test::antenna_at(p.x(), p.y()));
    if (step % 10 != 9) continue;
    for (const BeaconEstimate& estimate : mapper.estimates()) {
      note_claims(estimate, truth[estimate.id], scores);
    }
  }
  for (const BeaconEstimate& estimate : mapper.estimates()) {
    if (estimate.ranges > 50) note_end(estimate, truth[estimate.id], scores);
  }
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// Of the modes that claim a weight in [low, high): the share that is right, less the mean claim.
double miscalibration(const std::vector<Claim>& claims, double low, double high) {
  double claimed = 0.0;
  double right = 0.0;
  double count = 0.0;
  for (const Claim& claim : claims) {
    if (claim.weight < low || claim.weight >= high) continue;
    claimed += claim.weight;
    right += claim.is_true;
    ++count;
  }
  return count == 0.0 ? 0.0 : (right - claimed) / count;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Scores runs(const BeaconOptions& options, double scale, double bias) {
  Scores scores;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) run(seed, options, scale, bias, scores);
  return scores;
}

void expect_honest_weights(const Scores& scores) {
  EXPECT_LT(std::abs(miscalibration(scores.claims, 0.4, 0.6)), 0.05);
  EXPECT_LT(std::abs(miscalibration(scores.claims, 0.6, 0.8)), 0.2);
  EXPECT_LT(std::abs(miscalibration(scores.claims, 0.8, 1.1)), 0.02);
}

void expect_true_modes(const Scores& scores, double share) {
  ASSERT_GT(scores.errors.size(), 200u);
  EXPECT_GT(scores.strongest_is_true, share * static_cast<double>(scores.errors.size()));
}

TEST(BeaconSimulation, KnownDeviceAndPoses) {
  const Scores scores = runs(beacon_test::calibrated(), 1.0, 0.0);
  expect_true_modes(scores, 0.98);
  expect_honest_weights(scores);
  EXPECT_LT(median(scores.errors), 0.025);
  EXPECT_LT(*std::max_element(scores.errors.begin(), scores.errors.end()), 0.3);
  // 209 values of a chi-squared variable with 2 degrees: the mean is in 2 +- 0.41 in 99.7 %.
  EXPECT_NEAR(mean(scores.nees), 2.0, 0.41);
}

TEST(BeaconSimulation, UnknownDevice) {
  BeaconOptions options;
  options.drift = 0.0;
  const Scores scores = runs(options, 1.04, 0.1);
  expect_true_modes(scores, 0.96);
  expect_honest_weights(scores);
  EXPECT_LT(median(scores.errors), 0.035);
  EXPECT_NEAR(median(scores.nees), 2.0 * std::log(2.0), 0.4);
}

TEST(BeaconSimulation, UnknownDeviceAndDefaultOptions) {
  const Scores scores = runs(BeaconOptions{}, 1.04, 0.1);
  expect_true_modes(scores, 0.98);
  expect_honest_weights(scores);
  EXPECT_LT(median(scores.errors), 0.04);
  EXPECT_LT(*std::max_element(scores.errors.begin(), scores.errors.end()), 0.4);
  EXPECT_LT(mean(scores.nees), 2.41);  // it allows for drift that is not there
}

}  // namespace
}  // namespace portolan
