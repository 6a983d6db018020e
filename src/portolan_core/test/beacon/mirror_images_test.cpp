// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {
namespace {

const Eigen::Vector3d kBeacon(4.0, 3.0, 0.0);
constexpr int kStanding = 10;   // ranges before the robot sets off
constexpr double kStep = 0.12;  // [m]

/// What modes on the left of the straight way weigh together.
double left_weight(const BeaconMapper& mapper) {
  double left = 0.0;
  const BeaconEstimate beacon = mapper.estimates()[0];
  for (const BeaconMode& mode : beacon.modes) {
    if (mode.mean.y() > 0.0) left += mode.weight;
  }
  return left;
}

TEST(MirrorImages, KeepEqualWeightsHoweverSmallTheStepsAre) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    beacon_test::Dice dice(seed);
    BeaconMapper mapper(beacon_test::calibrated());
    for (int step = 0; step < kStanding + 50; ++step) {
      const Pose pose = beacon_test::antenna_at(kStep * std::max(0, step - kStanding), 0.0);
      const double range = (kBeacon - pose.translation()).norm() + dice.normal(0.1);
      mapper.insert(beacon_test::one_range(1, range, 0.1), pose);
    }
    EXPECT_NEAR(left_weight(mapper), 0.5, 0.08) << "seed " << seed;
  }
}

}  // namespace
}  // namespace portolan
