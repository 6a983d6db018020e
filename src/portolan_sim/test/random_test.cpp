// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace portolan::sim {
namespace {

TEST(Random, IsTheSameForTheSameSeedAndStreamAndElseAnother) {
  Random a(1, "laser");
  Random b(1, "laser");
  Random other_stream(1, "sonar");
  Random other_seed(2, "laser");
  for (int i = 0; i < 100; ++i) {
    const double x = a.uniform();
    EXPECT_EQ(x, b.uniform());
    EXPECT_NE(x, other_stream.uniform());
    EXPECT_NE(x, other_seed.uniform());
  }
}

TEST(Random, NormalHasTheMomentsOfANormal) {
  Random random(3, "normal");
  constexpr int kDraws = 200000;
  double sum = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
  EXPECT_NEAR(fourths / kDraws, 3.0, 0.1);
}

TEST(Random, UniformStaysInItsIntervalAndFillsIt) {
  Random random(4, "uniform");
  double low = 1.0;
  double high = 0.0;
  double sum = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform();
    low = std::min(low, x);
    high = std::max(high, x);
    sum += x;
  }
  EXPECT_GE(low, 0.0);
  EXPECT_LT(high, 1.0);
  EXPECT_LT(low, 0.001);
  EXPECT_GT(high, 0.999);
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
}

TEST(Random, CountsHappenAsOftenAsAsked) {
  Random random(5, "count");
  for (const double mean : {0.0, 0.3, 4.0}) {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kDraws = 50000;
    for (int i = 0; i < kDraws; ++i) {
      const int count = random.count(mean);
      sum += count;
      squares += count * count;
    }
    const double average = sum / kDraws;
    EXPECT_NEAR(average, mean, 0.05);
    EXPECT_NEAR(squares / kDraws - average * average, mean, 0.12);
  }
}

TEST(Random, IndexReachesEveryPlaceAlike) {
  Random random(6, "index");
  std::vector<int> times(7, 0);
  for (int i = 0; i < 70000; ++i) ++times.at(random.index(times.size()));
  for (const int n : times) EXPECT_NEAR(n, 10000, 400);
}

}  // namespace
}  // namespace portolan::sim
