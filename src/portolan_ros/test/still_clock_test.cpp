// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/still_clock.hpp"

#include <gtest/gtest.h>

namespace portolan {
namespace {

using std::chrono::milliseconds;

Time at(double s) { return Time(seconds(s)); }

TEST(StillClock, StandsOnceTimeHasBeenTheSameForASecond) {
  const StillClock::RealTime begin{};
  StillClock clock;
  EXPECT_FALSE(clock.stands(at(10.0), begin));
  EXPECT_FALSE(clock.stands(at(10.0), begin + milliseconds(999)));
  EXPECT_TRUE(clock.stands(at(10.0), begin + milliseconds(1000)));
  EXPECT_TRUE(clock.stands(at(10.0), begin + milliseconds(5000)));
}

TEST(StillClock, GoesOnWithEachTickForwardOrBack) {
  const StillClock::RealTime begin{};
  StillClock clock;
  EXPECT_FALSE(clock.stands(at(10.0), begin));
  EXPECT_FALSE(clock.stands(at(10.1), begin + milliseconds(900)));
  EXPECT_FALSE(clock.stands(at(10.1), begin + milliseconds(1800)));
  EXPECT_TRUE(clock.stands(at(10.1), begin + milliseconds(1900)));
  EXPECT_FALSE(clock.stands(at(0.0), begin + milliseconds(2000)));
}

}  // namespace
}  // namespace portolan
