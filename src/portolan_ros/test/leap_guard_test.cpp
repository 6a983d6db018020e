// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/leap_guard.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace portolan {
namespace {

/// The verdicts on these stamps [s], a letter each: good, doubtful, ran back.
std::string verdicts(const std::vector<double>& stamps) {
  LeapGuard guard(seconds(30.0));
  std::string letters;
  for (const double s : stamps) {
    letters +=
        enum_names(StampVerdict{})[static_cast<std::size_t>(guard.judge(Time(seconds(s))))][0];
  }
  return letters;
}

TEST(LeapGuard, FollowsStampsThatGoOn) {
  EXPECT_EQ(verdicts({100.0, 100.0, 101.0, 131.0, 130.0, 101.0, 160.0}), "ggggggg");
}

TEST(LeapGuard, DoubtsALoneWildStamp) {
  EXPECT_EQ(verdicts({100.0, 101.0, 2000.0, 102.0, 103.0}), "ggdgg");
  EXPECT_EQ(verdicts({100.0, 101.0, 3.0, 102.0, 103.0}), "ggdgg");
}

TEST(LeapGuard, NeverBelievesASecondSenderWithAWrongClock) {
  EXPECT_EQ(verdicts({100.0, 5.0, 100.1, 5.1, 100.2, 5.2, 100.3}), "gdgdgdg");
  EXPECT_EQ(verdicts({100.0, 900.0, 100.1, 900.1, 100.2, 900.2}), "gdgdgd");
}

TEST(LeapGuard, BelievesALeapThatGoesOn) {
  EXPECT_EQ(verdicts({100.0, 5.0, 5.1, 5.2, 35.0}), "gdrgg");
  EXPECT_EQ(verdicts({100.0, 500.0, 500.1, 500.2}), "gdgg");
}

TEST(LeapGuard, DoubtsEachOfSeveralWildStamps) {
  EXPECT_EQ(verdicts({100.0, 500.0, 900.0, 5.0, 100.1}), "gdddg");
}

}  // namespace
}  // namespace portolan
