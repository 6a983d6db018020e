// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/beacon_mapper.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "beacon/scenario.hpp"
#include "portolan/beacon/expected_information.hpp"

namespace portolan {
namespace {

using beacon_test::antenna_at;
using beacon_test::calibrated;
using beacon_test::Dice;
using beacon_test::one_range;

constexpr int kStraight = 12;
const Eigen::Vector3d kBeacon(4.0, 5.0, 0.0);

BeaconMapper drive_figure_11(int steps, BeaconOptions options, std::uint32_t seed) {
  Dice dice(seed);
  BeaconMapper mapper(options);
  for (int step = 0; step < steps; ++step) {
    const Pose pose = beacon_test::figure_11(step, kStraight);
    const double range = (kBeacon - pose.translation()).norm() + dice.normal(0.1);
    EXPECT_EQ(mapper.insert(one_range(7, range, 0.1), pose), Outcome::inserted);
  }
  return mapper;
}

std::vector<BeaconMode> modes_above(const BeaconEstimate& estimate, double weight) {
  std::vector<BeaconMode> modes;
  for (const BeaconMode& mode : estimate.modes) {
    if (mode.weight > weight) modes.push_back(mode);
  }
  return modes;
}

double mahalanobis_squared(const BeaconMode& mode, const Eigen::Vector3d& p) {
  const Eigen::Vector2d step = (p - mode.mean).head<2>();
  const Eigen::Matrix2d P = mode.covariance.topLeftCorner<2, 2>();
  return step.dot(P.inverse() * step);
}

class BeaconMapperBothWays : public ::testing::TestWithParam<BeaconParametrization> {
 protected:
  static BeaconOptions options() {
    BeaconOptions options = calibrated();
    options.parametrization = GetParam();
    return options;
  }
};

INSTANTIATE_TEST_SUITE_P(Parametrizations, BeaconMapperBothWays,
                         ::testing::Values(BeaconParametrization::cartesian_mixture,
                                           BeaconParametrization::polar),
                         [](const auto& tested) {
                           return std::string(
                               enum_names(tested.param)[static_cast<std::size_t>(tested.param)]);
                         });

TEST_P(BeaconMapperBothWays, AStraightPathLeavesTwoMirrorImages) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const BeaconEstimate beacon = drive_figure_11(kStraight, options(), seed).estimates()[0];
    const std::vector<BeaconMode> modes = modes_above(beacon, 0.05);
    ASSERT_EQ(modes.size(), 2u) << "seed " << seed;
    EXPECT_TRUE(beacon.ambiguous);
    EXPECT_NEAR(modes[0].weight, modes[1].weight, 0.1);
    EXPECT_NEAR(modes[0].mean.x(), modes[1].mean.x(), 0.1);
    EXPECT_NEAR(modes[0].mean.y(), -modes[1].mean.y(), 0.1);
  }
}

TEST_P(BeaconMapperBothWays, AfterTheTurnOneModeIsLeftAndItIsTrue) {
  int within = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const BeaconEstimate beacon = drive_figure_11(24, options(), seed).estimates()[0];
    ASSERT_EQ(modes_above(beacon, 0.01).size(), 1u) << "seed " << seed;
    EXPECT_FALSE(beacon.ambiguous);
    EXPECT_LT((beacon.modes[0].mean - kBeacon).norm(), 0.5);
    within += mahalanobis_squared(beacon.modes[0], kBeacon) < 9.0;
  }
  EXPECT_GE(within, 19);
}

TEST(BeaconMapper, SaysToDriveOffTheLineThatLeavesAMirrorImage) {
  const BeaconEstimate beacon = drive_figure_11(kStraight, calibrated(), 1).estimates()[0];
  ASSERT_TRUE(beacon.drive);
  EXPECT_NEAR(beacon.drive->direction.norm(), 1.0, 1e-12);
  const Eigen::Vector3d here = beacon_test::figure_11(kStraight - 1, kStraight).translation();
  const double told = expected_information(beacon.modes, here + beacon.drive->direction, 0.1);
  const double straight_on =
      expected_information(beacon.modes, here + Eigen::Vector3d(1.0, 0.0, 0.0), 0.1);
  EXPECT_GT(std::abs(beacon.drive->direction.y()), 0.3);
  EXPECT_GT(told, straight_on + 0.9 * std::log(2.0));  // ln 2: which of two it is
}

TEST(BeaconMapper, SurvivesThousandsOfRanges) {
  Dice dice(3);
  BeaconMapper mapper(calibrated());
  for (int step = 0; step < 5000; ++step) {
    const Pose pose = antenna_at(3.0 * std::cos(0.01 * step), 3.0 * std::sin(0.01 * step));
    const double range = (kBeacon - pose.translation()).norm() + dice.normal(0.01);
    mapper.insert(one_range(1, range, 0.01), pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_LT((beacon.modes[0].mean - kBeacon).norm(), 0.003);
  EXPECT_NEAR(beacon.modes[0].weight, 1.0, 1e-6);
  EXPECT_EQ(beacon.restarts, 0u);
}

TEST_P(BeaconMapperBothWays, FindsABeaconInSpace) {
  BeaconOptions spatial = options();
  spatial.space = BeaconSpace::spatial;
  const Eigen::Vector3d truth(2.0, 3.0, 1.5);
  Dice dice(5);
  BeaconMapper mapper(spatial);
  for (int step = 0; step < 200; ++step) {
    const Pose pose = antenna_at(2.0 * std::cos(0.1 * step), 2.0 * std::sin(0.1 * step),
                                 0.8 * std::sin(0.037 * step));
    mapper.insert(one_range(1, (truth - pose.translation()).norm() + dice.normal(0.05), 0.05),
                  pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_FALSE(beacon.ambiguous);
  EXPECT_LT((beacon.modes[0].mean - truth).norm(), 0.06);
}

TEST(BeaconMapper, FromOneHeightABeaconInSpaceStaysAmbiguous) {
  BeaconOptions options = calibrated();
  options.space = BeaconSpace::spatial;
  const Eigen::Vector3d truth(2.0, 3.0, 1.5);
  BeaconMapper mapper(options);
  for (int step = 0; step < 200; ++step) {
    const Pose pose = antenna_at(2.0 * std::cos(0.1 * step), 2.0 * std::sin(0.1 * step));
    mapper.insert(one_range(1, (truth - pose.translation()).norm(), 0.05), pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_TRUE(beacon.ambiguous);
  EXPECT_NEAR(beacon.modes[0].mean.z(), -beacon.modes[1].mean.z(), 0.02);
  ASSERT_TRUE(beacon.drive);
  EXPECT_GT(std::abs(beacon.drive->direction.z()), 0.9);
}

TEST_P(BeaconMapperBothWays, ABeaconThatStartedFromAWrongRangeRecovers) {
  Dice dice(9);
  BeaconMapper mapper(options());
  mapper.insert(one_range(1, 25.0, 0.1), antenna_at(0.0, 0.0));
  for (int step = 0; step < 60; ++step) {
    const Pose pose = beacon_test::figure_11(step, kStraight);
    mapper.insert(one_range(1, (kBeacon - pose.translation()).norm() + dice.normal(0.1), 0.1),
                  pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_EQ(beacon.restarts, 1u);
  EXPECT_LT(mahalanobis_squared(beacon.modes[0], kBeacon), 9.0);
}

TEST(BeaconMapper, ABeaconThatWasMovedIsNoticedUnlessToldNotTo) {
  for (const bool enabled : {true, false}) {
    BeaconOptions options = calibrated();
    options.restart.enabled = enabled;
    Dice dice(9);
    BeaconMapper mapper(options);
    const Eigen::Vector3d moved(-3.0, 2.0, 0.0);
    for (int step = 0; step < 160; ++step) {
      const Pose pose = beacon_test::figure_11(step, kStraight);
      const Eigen::Vector3d& truth = step < 80 ? kBeacon : moved;
      mapper.insert(one_range(1, (truth - pose.translation()).norm() + dice.normal(0.1), 0.1),
                    pose);
    }
    const BeaconEstimate beacon = mapper.estimates()[0];
    EXPECT_EQ(beacon.restarts > 0, enabled);
    EXPECT_EQ((beacon.modes[0].mean - moved).norm() < 0.3, enabled);
  }
}

TEST(BeaconMapper, WrongRangesAreCountedAndSurvived) {
  Dice dice(4);
  BeaconMapper mapper(calibrated());
  int wrong = 0;
  for (int step = 0; step < 300; ++step) {
    const Pose pose = beacon_test::figure_11(step, kStraight);
    double range = (kBeacon - pose.translation()).norm() + dice.normal(0.1);
    if (step > 0 && dice.uniform(0.0, 1.0) < 0.2) {
      range += dice.uniform(1.0, 8.0);
      ++wrong;
    }
    mapper.insert(one_range(1, range, 0.1), pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_NEAR(static_cast<double>(beacon.outliers), wrong, 4.0);
  EXPECT_LT((beacon.modes[0].mean - kBeacon).norm(), 0.1);
}

TEST(BeaconMapper, MalformedRangesAreUnusableAndCounted) {
  BeaconMapper mapper(calibrated());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double range : {0.0, -1.0, nan, infinity}) {
    EXPECT_EQ(mapper.insert(one_range(1, range, 0.1), Pose::Identity()), Outcome::unusable);
  }
  for (const double stddev : {-1.0, nan, infinity}) {
    EXPECT_EQ(mapper.insert(one_range(1, 3.0, stddev), Pose::Identity()), Outcome::unusable);
  }
  EXPECT_EQ(mapper.counts().malformed, 7u);
  EXPECT_TRUE(mapper.tracks().empty());
  BeaconRanges mixed = one_range(1, nan, 0.1);
  mixed.ranges.push_back({2, 3.0, 0.1});
  EXPECT_EQ(mapper.insert(mixed, Pose::Identity()), Outcome::inserted);
  EXPECT_EQ(mapper.insert(BeaconRanges{}, Pose::Identity()), Outcome::inserted);
  EXPECT_EQ(mapper.counts().malformed, 8u);
  EXPECT_EQ(mapper.tracks().size(), 1u);
}

TEST(BeaconMapper, NumbersOfAnySizeLeaveAMapOfNumbers) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const auto any = [&] { return std::pow(10.0, 15.0 * dice.normal(1.0)); };
    BeaconMapper mapper(BeaconOptions{});
    for (int i = 0; i < 6; ++i) {
      mapper.insert(one_range(dice.normal(1.0) > 0.0 ? 1 : 2, any(), any()),
                    antenna_at(0.5 * i, 0.1 * i * i));
    }
    for (const BeaconEstimate& beacon : mapper.estimates()) {
      EXPECT_TRUE(beacon.modes[0].mean.allFinite()) << seed;
      EXPECT_TRUE(beacon.modes[0].covariance.allFinite()) << seed;
    }
  }
}

TEST(BeaconMapper, ThousandsOfIdsAreCappedAndCounted) {
  BeaconOptions options = calibrated();
  options.max_beacons = 10;
  BeaconMapper mapper(options);
  for (BeaconId id = 0; id < 5000; ++id) {
    const Outcome outcome = mapper.insert(one_range(id, 3.0, 0.1), Pose::Identity());
    EXPECT_EQ(outcome, id < 10 ? Outcome::inserted : Outcome::rejected);
  }
  EXPECT_EQ(mapper.tracks().size(), 10u);
  EXPECT_EQ(mapper.counts().refused, 4990u);
  EXPECT_EQ(mapper.counts().taken, 10u);
}

TEST(BeaconMapper, RangesBeyondTheDevicesReachAreRejected) {
  BeaconMapper mapper(calibrated());
  EXPECT_EQ(mapper.insert(one_range(1, 201.0, 0.1), Pose::Identity()), Outcome::rejected);
  EXPECT_EQ(mapper.counts().too_long, 1u);
}

TEST_P(BeaconMapperBothWays, AKnownHeightIsTakenOut) {
  BeaconOptions above = options();
  above.height = 2.5;
  Dice dice(2);
  BeaconMapper mapper(above);
  const Eigen::Vector3d truth = kBeacon + Eigen::Vector3d(0.0, 0.0, 2.5 + 0.4);
  for (int step = 0; step < 60; ++step) {
    Pose pose = beacon_test::figure_11(step, kStraight);
    pose.translation().z() = 0.4;
    mapper.insert(one_range(1, (truth - pose.translation()).norm() + dice.normal(0.05), 0.05),
                  pose);
  }
  const BeaconEstimate beacon = mapper.estimates()[0];
  EXPECT_LT((beacon.modes[0].mean - kBeacon).norm(), 0.08);
  EXPECT_EQ(beacon.modes[0].mean.z(), 0.0);
}

TEST(BeaconMapper, BadOptionsAreRefusedWithEveryFault) {
  BeaconOptions options;
  options.stddev = -1.0;
  options.outliers.share = 2.0;
  try {
    BeaconMapper mapper(options);
    FAIL();
  } catch (const OptionsError& error) {
    EXPECT_EQ(error.faults().size(), 2u);
  }
}

}  // namespace
}  // namespace portolan
