// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/landmark_sightings.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace portolan {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LandmarkSighting, RangeAndElevationMayBeMissingAndAzimuthMayNot) {
  LandmarkSighting bearing_only;
  EXPECT_TRUE(is_usable(bearing_only));
  LandmarkSighting full{3, 2.0, 0.1, -0.2, 0.01, 0.02, 0.03};
  EXPECT_TRUE(is_usable(full));
  full.azimuth = kNan;
  EXPECT_FALSE(is_usable(full));
}

TEST(LandmarkSighting, NumbersThatCannotBeAreRefused) {
  for (const double range : {0.0, -1.0, kInfinity, -kInfinity}) {
    LandmarkSighting sighting;
    sighting.range = range;
    EXPECT_FALSE(is_usable(sighting)) << range;
  }
  for (const double stddev : {-0.1, kNan, kInfinity}) {
    LandmarkSighting sighting;
    sighting.azimuth_stddev = stddev;
    EXPECT_FALSE(is_usable(sighting)) << stddev;
  }
  LandmarkSighting sighting;
  sighting.elevation = kInfinity;
  EXPECT_FALSE(is_usable(sighting));
}

TEST(LandmarkSightings, AreUsableUnlessAllAreMalformed) {
  LandmarkSightings z;
  EXPECT_TRUE(is_usable(z));
  z.sightings.resize(2);
  EXPECT_TRUE(is_usable(z));
  z.sightings[1].azimuth = kNan;
  EXPECT_TRUE(is_usable(z));
  z.sightings[0].azimuth = kNan;
  EXPECT_FALSE(is_usable(z));
}

TEST(LandmarkSightings, ByteSizeGrowsWithTheirNumber) {
  LandmarkSightings z;
  const std::size_t empty = byte_size(z);
  z.sightings.resize(10);
  EXPECT_GE(byte_size(z), empty + 10 * sizeof(LandmarkSighting));
}

}  // namespace
}  // namespace portolan
