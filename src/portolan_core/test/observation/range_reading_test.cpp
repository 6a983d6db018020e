// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_reading.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "portolan/options/value.hpp"

namespace portolan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Row {
  double range;
  double range_min;
  double range_max;
  RangeReading expected;
};

TEST(RangeReading, MeansWhatRep117Says) {
  constexpr RangeReading kHit = RangeReading::hit;
  constexpr RangeReading kNothing = RangeReading::nothing_returned;
  constexpr RangeReading kSilent = RangeReading::no_information;
  const Row table[] = {
      {kNan, 0.1, 10.0, kSilent},        // the measurement failed
      {-kNan, 0.1, 10.0, kSilent},       //
      {-kInfinity, 0.1, 10.0, kSilent},  // too close to measure
      {kInfinity, 0.1, 10.0, kNothing},  // nothing within reach
      {0.0, 0.0, 10.0, kSilent},         // what drivers send for "none"
      {-0.0, 0.0, 10.0, kSilent},        //
      {-1.0, 0.0, 10.0, kSilent},        //
      {0.05, 0.1, 10.0, kSilent},        // below range_min
      {0.1, 0.1, 10.0, kHit},            // the limits: from range_min on
      {1e-9, 0.0, 10.0, kHit},           //
      {9.999, 0.1, 10.0, kHit},          //
      {10.0, 0.1, 10.0, kNothing},       // up to, and without, range_max
      {11.0, 0.1, 10.0, kNothing},       //
      {-kInfinity, 2.0, 2.0, kSilent},   // a ranger of fixed distance: something, at any range
      {kInfinity, 2.0, 2.0, kNothing},   // nothing
      {2.0, 2.0, 2.0, kSilent},          // and it has no other words
      {1.0, 2.0, 2.0, kSilent},          //
      {3.0, 2.0, 2.0, kSilent},          //
      {kNan, 2.0, 2.0, kSilent},         //
      {1.0, 2.0, 0.5, kSilent},          // limits that make no sense
      {1.0, kNan, 10.0, kSilent},        //
      {1.0, 0.1, kNan, kSilent},         //
  };
  for (const Row& row : table) {
    EXPECT_EQ(range_reading(row.range, row.range_min, row.range_max), row.expected)
        << row.range << " in [" << row.range_min << ", " << row.range_max << "]";
  }
}

TEST(RangeReading, NamesStandInTheOrderOfTheEnumerators) {
  EXPECT_EQ(options_detail::format(RangeReading::hit), "hit");
  EXPECT_EQ(options_detail::format(RangeReading::nothing_returned), "nothing_returned");
  EXPECT_EQ(options_detail::format(RangeReading::no_information), "no_information");
  EXPECT_EQ(options_detail::format(NoReturn::ignore), "ignore");
  EXPECT_EQ(options_detail::format(NoReturn::clear), "clear");
}

}  // namespace
}  // namespace portolan
