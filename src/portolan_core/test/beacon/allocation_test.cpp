// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "beacon/allocations.hpp"
#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {
namespace {

// Drives a circle and a wiggle among four beacons; the number of allocations in the mapper.
std::size_t allocations_while(BeaconMapper& mapper, int from, int to) {
  std::size_t counted = 0;
  beacon_test::Dice dice(static_cast<std::uint32_t>(from));
  for (int step = from; step < to; ++step) {
    const Pose pose = beacon_test::figure_11(step, 30);
    BeaconRanges z;
    for (BeaconId id = 0; id < 4; ++id) {
      const Eigen::Vector3d beacon(4.0 * id - 6.0, 5.0 - 2.0 * id, 0.0);
      z.ranges.push_back({id, (beacon - pose.translation()).norm() + dice.normal(0.1), 0.1});
    }
    const std::size_t before = allocations();
    mapper.insert(z, pose);
    counted += allocations() - before;
  }
  return counted;
}

TEST(BeaconMapperAllocations, NoneOnceABeaconIsKnown) {
  for (const BeaconParametrization parametrization :
       {BeaconParametrization::cartesian_mixture, BeaconParametrization::polar}) {
    BeaconOptions options;
    options.parametrization = parametrization;
    BeaconMapper mapper(options);
    EXPECT_GT(allocations_while(mapper, 0, 1), 0U);
    const int warm = parametrization == BeaconParametrization::polar ? 12 : 1;
    allocations_while(mapper, 1, warm);  // polar modes split as the robot leaves the first place
    EXPECT_EQ(allocations_while(mapper, warm, 300), 0U);
  }
}

}  // namespace
}  // namespace portolan
