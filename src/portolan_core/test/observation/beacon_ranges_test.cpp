// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/beacon_ranges.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace portolan {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(BeaconRange, NumbersThatCannotBeAreRefused) {
  EXPECT_TRUE(is_usable(BeaconRange{1, 3.0, 0.0}));
  EXPECT_TRUE(is_usable(BeaconRange{1, 0.5, 0.1}));
  for (const double range : {0.0, -0.1, 1e-30, kNan, kInfinity}) {
    EXPECT_FALSE(is_usable(BeaconRange{1, range, 0.1})) << range;
  }
  for (const double stddev : {-0.1, 1e30, kNan, kInfinity}) {
    EXPECT_FALSE(is_usable(BeaconRange{1, 3.0, stddev})) << stddev;
  }
}

TEST(BeaconRanges, AreUsableUnlessAllAreMalformed) {
  BeaconRanges z;
  EXPECT_TRUE(is_usable(z));
  z.ranges = {{1, 2.0, 0.0}, {2, kNan, 0.0}};
  EXPECT_TRUE(is_usable(z));
  z.ranges = {{1, -2.0, 0.0}, {2, kNan, 0.0}};
  EXPECT_FALSE(is_usable(z));
}

TEST(BeaconRanges, ByteSizeGrowsWithTheirNumber) {
  BeaconRanges z;
  const std::size_t empty = byte_size(z);
  z.ranges.resize(10);
  EXPECT_GE(byte_size(z), empty + 10 * sizeof(BeaconRange));
}

}  // namespace
}  // namespace portolan
