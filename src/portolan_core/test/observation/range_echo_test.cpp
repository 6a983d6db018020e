// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_echo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace portolan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RangeEcho, IsUsableWithAnyRange) {
  for (const double range : {1.0, 0.0, -1.0, 100.0, kInfinity, -kInfinity, kNan}) {
    EXPECT_TRUE(is_usable({range, 0.1, 4.0, 0.5})) << range;
  }
  EXPECT_TRUE(is_usable({1.0, 2.0, 2.0, 0.5}));  // a ranger of fixed distance
  EXPECT_TRUE(is_usable({1.0, 0.0, 4.0, 2.0 * M_PI}));
}

TEST(RangeEcho, IsNotUsableWithLimitsOrApertureThatMakeNoSense) {
  for (const double aperture : {0.0, -0.1, 6.3, kInfinity, kNan}) {
    EXPECT_FALSE(is_usable({1.0, 0.1, 4.0, aperture})) << aperture;
  }
  for (const double range_min : {-0.1, 4.1, kInfinity, -kInfinity, kNan}) {
    EXPECT_FALSE(is_usable({1.0, range_min, 4.0, 0.5})) << range_min;
  }
  for (const double range_max : {0.05, -1.0, kInfinity, kNan}) {
    EXPECT_FALSE(is_usable({1.0, 0.1, range_max, 0.5})) << range_max;
  }
}

TEST(RangeEcho, OccupiesItself) { EXPECT_EQ(byte_size(RangeEcho{}), sizeof(RangeEcho)); }

}  // namespace
}  // namespace portolan
