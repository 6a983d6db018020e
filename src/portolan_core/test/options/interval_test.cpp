// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/interval.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace portolan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Row {
  Interval interval;
  const char* words;
  std::vector<double> in;
  std::vector<double> out;
};

TEST(Interval, ContainsWhatItsWordsSay) {
  const std::vector<Row> table = {
      {finite(), "finite", {0.0, -1e308, 1e308}, {kInfinity, -kInfinity}},
      {above(0.0), "above 0", {1e-300, 7.0}, {0.0, -1.0, kInfinity}},
      {at_least(-1.0), "at least -1", {-1.0, 7.0}, {-1.1, kInfinity}},
      {between(0.5, 1.0), "in (0.5, 1)", {0.7}, {0.5, 1.0, 2.0, 0.0}},
      {within(0.5, 1.0), "in [0.5, 1]", {0.5, 0.7, 1.0}, {0.4, 1.1}},
      {above_to(0.5, 1.0), "in (0.5, 1]", {0.7, 1.0}, {0.5, 1.1}},
      {{-kInfinity, 3.0, true, true}, "below 3", {2.9}, {3.0, -kInfinity}},
      {{-kInfinity, 3.0, true, false}, "at most 3", {3.0}, {3.1}},
  };
  for (const Row& row : table) {
    EXPECT_EQ(row.interval.words(), row.words);
    for (const double value : row.in) EXPECT_TRUE(row.interval.contains(value)) << row.words;
    for (const double value : row.out) EXPECT_FALSE(row.interval.contains(value)) << row.words;
    EXPECT_FALSE(row.interval.contains(std::numeric_limits<double>::quiet_NaN()));
  }
}

}  // namespace
}  // namespace portolan
