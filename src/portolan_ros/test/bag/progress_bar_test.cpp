// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/progress_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

namespace portolan {
namespace {

TEST(ProgressBar, MovesOnATerminal) {
  std::ostringstream out;
  ProgressBar bar(out, true, "grid");
  bar.show(0.0);
  EXPECT_EQ(out.str(), "\rgrid [" + std::string(40, ' ') + "] 0 %");
  out.str("");
  bar.show(0.5);
  EXPECT_EQ(out.str(), "\rgrid [" + std::string(20, '#') + std::string(20, ' ') + "] 50 %");
  out.str("");
  bar.finish();
  EXPECT_EQ(out.str(), "\rgrid [" + std::string(40, '#') + "] 100 %\n");
}

TEST(ProgressBar, WritesOnATerminalOnlyWhatChanges) {
  std::ostringstream out;
  ProgressBar bar(out, true, "grid");
  for (int i = 0; i <= 100000; ++i) bar.show(i / 100000.0);
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 101);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
}

TEST(ProgressBar, WritesALineEachTenthElsewhere) {
  std::ostringstream out;
  ProgressBar bar(out, false, "grid");
  for (int i = 0; i <= 1000; ++i) bar.show(i / 1000.0);
  bar.finish();
  std::string expected;
  for (int percent = 0; percent <= 100; percent += 10) {
    expected += "grid " + std::to_string(percent) + " %\n";
  }
  EXPECT_EQ(out.str(), expected);
}

TEST(ProgressBar, EndsAtTheEndOfWorkThatNeverBegan) {
  std::ostringstream out;
  ProgressBar(out, false, "grid").finish();
  EXPECT_EQ(out.str(), "grid 100 %\n");
}

TEST(ProgressBar, KeepsWithinItsEnds) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double low : {-0.5, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    std::ostringstream out;
    ProgressBar(out, false, "grid").show(low);
    EXPECT_EQ(out.str(), "grid 0 %\n");
  }
  for (const double high : {1.5, 1e300, inf}) {
    std::ostringstream out;
    ProgressBar(out, false, "grid").show(high);
    EXPECT_EQ(out.str(), "grid 100 %\n");
  }
}

}  // namespace
}  // namespace portolan
