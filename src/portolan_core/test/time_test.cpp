// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/time.hpp"

#include <gtest/gtest.h>

#include <random>

namespace portolan {
namespace {

static_assert(seconds(1.5) == std::chrono::milliseconds(1500));
static_assert(seconds(-0.25) == -std::chrono::milliseconds(250));
static_assert(to_seconds(std::chrono::milliseconds(-20)) == -0.02);

TEST(Time, SecondsAreRoundedToTheNearestNanosecond) {
  EXPECT_EQ(seconds(0.29), std::chrono::milliseconds(290));  // 0.29 * 1e9 is a little less
  EXPECT_EQ(seconds(-0.29), -std::chrono::milliseconds(290));
  EXPECT_EQ(seconds(0.4e-9).count(), 0);
  EXPECT_EQ(seconds(-0.6e-9).count(), -1);
}

TEST(Time, ADurationOfWeeksSurvivesAsSeconds) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<Duration::rep> nanoseconds(-4'000'000'000'000'000,
                                                           4'000'000'000'000'000);
  for (int i = 0; i < 10000; ++i) {
    const Duration duration(nanoseconds(random));
    EXPECT_EQ(seconds(to_seconds(duration)), duration);
  }
}

TEST(Time, StampsKeepNanosecondsFarFromTheirEpoch) {
  const Time stamp(std::chrono::hours(24 * 365 * 60) + Duration(1));
  EXPECT_EQ((stamp - Time(std::chrono::hours(24 * 365 * 60))).count(), 1);
}

}  // namespace
}  // namespace portolan
