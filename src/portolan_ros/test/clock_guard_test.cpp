// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/clock_guard.hpp"

#include <gtest/gtest.h>

namespace portolan {
namespace {

Time at(double s) { return Time(seconds(s)); }

TEST(ClockGuard, LetsTimeGoOnAndStand) {
  ClockGuard guard(seconds(0.5));
  for (const double now : {0.0, 0.0, 1.0, 1.0, 5.0, 1e9, 1e9}) {
    EXPECT_FALSE(guard.ran_back(at(now))) << now;
  }
}

TEST(ClockGuard, NoticesAStepBackOnce) {
  ClockGuard guard(seconds(0.5));
  EXPECT_FALSE(guard.ran_back(at(10.0)));
  EXPECT_TRUE(guard.ran_back(at(2.0)));
  EXPECT_FALSE(guard.ran_back(at(2.0)));
  EXPECT_FALSE(guard.ran_back(at(2.1)));
  EXPECT_TRUE(guard.ran_back(at(0.0)));
}

TEST(ClockGuard, ToleratesSmallSteps) {
  ClockGuard guard(seconds(0.5));
  EXPECT_FALSE(guard.ran_back(at(10.0)));
  EXPECT_FALSE(guard.ran_back(at(9.5)));
}

TEST(ClockGuard, SmallStepsDoNotAddUpUnnoticed) {
  ClockGuard guard(seconds(0.5));
  EXPECT_FALSE(guard.ran_back(at(10.0)));
  EXPECT_FALSE(guard.ran_back(at(9.7)));
  EXPECT_TRUE(guard.ran_back(at(9.4)));
}

}  // namespace
}  // namespace portolan
