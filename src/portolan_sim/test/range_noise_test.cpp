// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/range_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace portolan::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDraws = 50000;

TEST(RangeNoise, HasTheDeviationItWasGiven) {
  RangeNoise noise;
  noise.range_stddev = 0.02;
  noise.stddev_per_metre = 0.01;
  Random random(1, "noise");
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double error = noise.measure(3.0, random) - 3.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 0.05, 0.0007);
}

TEST(RangeNoise, DropsOutAndErrsAsOftenAsAsked) {
  RangeNoise noise;
  noise.range_stddev = 0.0;
  noise.dropout = 0.1;
  noise.outliers = 0.2;
  Random random(2, "noise");
  int dropped = 0;
  int wild = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double range = noise.measure(3.0, random);
    if (range == kInfinity) {
      ++dropped;
    } else if (range != 3.0) {
      ++wild;
      EXPECT_GE(range, noise.range_min);
      EXPECT_LT(range, noise.range_max);
    }
  }
  EXPECT_NEAR(dropped, 0.1 * kDraws, 300);
  EXPECT_NEAR(wild, 0.9 * 0.2 * kDraws, 400);
}

TEST(RangeNoise, SaysTooCloseAndNothingAsRep117Does) {
  RangeNoise noise;
  noise.range_stddev = 0.0;
  Random random(3, "noise");
  EXPECT_EQ(noise.measure(0.01, random), -kInfinity);
  EXPECT_EQ(noise.measure(noise.range_max, random), kInfinity);
  EXPECT_EQ(noise.measure(kInfinity, random), kInfinity);
  EXPECT_EQ(noise.measure(5.0, random), 5.0);
}

TEST(RangeNoise, OneReadingDoesNotShiftTheNextOnesNumbers) {
  RangeNoise noise;
  Random near(4, "noise");
  Random none(4, "noise");
  noise.measure(3.0, near);
  noise.measure(kInfinity, none);
  EXPECT_EQ(noise.measure(3.0, near), noise.measure(3.0, none));
}

}  // namespace
}  // namespace portolan::sim
