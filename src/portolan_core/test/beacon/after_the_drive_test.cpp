// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_file.hpp"
#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/beacon/expected_information.hpp"

namespace portolan {
namespace {

constexpr int kStraight = 12;
const Eigen::Vector3d kBeacon(4.0, 5.0, 0.0);

BeaconMapper drive_figure_11(int steps, const BeaconOptions& options) {
  beacon_test::Dice dice(1);
  BeaconMapper mapper(options);
  for (int step = 0; step < steps; ++step) {
    const Pose pose = beacon_test::figure_11(step, kStraight);
    const double range = (kBeacon - pose.translation()).norm() + dice.normal(0.1);
    mapper.insert(beacon_test::one_range(7, range, 0.1), pose);
  }
  return mapper;
}

TEST(BeaconMapperAfterTheDrive, WhereToDriveTellsLessTheWiderRangesSpread) {
  const BeaconMapper mapper = drive_figure_11(kStraight, beacon_test::calibrated());
  const BeaconEstimate beacon = mapper.estimates()[0];
  const PosedRange& last = *mapper.tracks().at(7).last();
  EXPECT_EQ(last.stddev, 0.1);  // as stated: that is what counts, not the options' 0.3
  const auto drive = best_drive(beacon.modes, last.p_map, last.stddev, BeaconSpace::planar);
  const auto coarse = best_drive(beacon.modes, last.p_map, 5.0 * last.stddev, BeaconSpace::planar);
  ASSERT_TRUE(beacon.drive && drive && coarse);
  EXPECT_EQ(beacon.drive->information, drive->information);
  EXPECT_LT(coarse->information, drive->information);
}

TEST(BeaconMapperAfterTheDrive, APlaceLongUnheardOfGrowsUncertainAsPosesDrift) {
  BeaconMapper mapper = drive_figure_11(40, BeaconOptions{});
  const BeaconMode before = mapper.estimates()[0].modes[0];
  const double variance = mapper.drift() * mapper.drift();
  const Pose there = beacon_test::antenna_at(100.0, 0.0);
  const double way =
      (there.translation() - beacon_test::figure_11(39, kStraight).translation()).norm();
  mapper.insert(BeaconRanges{}, there);
  const BeaconMode after = mapper.estimates()[0].modes[0];
  EXPECT_GE(after.covariance(0, 0), before.covariance(0, 0) + 0.99 * variance * way);
  EXPECT_GE(after.covariance(1, 1), before.covariance(1, 1) + 0.99 * variance * way);
}

TEST(BeaconMapperAfterTheDrive, WhatIsRejectedLeavesNoTraceOfItsPose) {
  BeaconMapper mapper = drive_figure_11(4, BeaconOptions{});
  BeaconMapper disturbed = mapper;
  EXPECT_EQ(
      disturbed.insert(beacon_test::one_range(7, 1e6, 0.1), beacon_test::antenna_at(100.0, -50.0)),
      Outcome::rejected);
  for (BeaconMapper* each : {&mapper, &disturbed}) {
    each->insert(beacon_test::one_range(7, 6.0, 0.1), beacon_test::antenna_at(1.0, 0.5));
  }
  EXPECT_EQ(to_yaml(disturbed), to_yaml(mapper));
}

}  // namespace
}  // namespace portolan
