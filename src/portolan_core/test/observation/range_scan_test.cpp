// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_scan.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace portolan {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

RangeScan good_scan() {
  RangeScan scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.5;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = {1.0F, 0.0F, kInfinity, -kInfinity, kNan};
  return scan;
}

template <class Change>
bool is_usable_after(Change change) {
  RangeScan scan = good_scan();
  change(scan);
  return is_usable(scan);
}

TEST(RangeScan, IsUsableWithAnyRangesInAnyNumber) {
  EXPECT_TRUE(is_usable(good_scan()));
  EXPECT_TRUE(is_usable_after([](RangeScan& scan) { scan.ranges = {1.0F}; }));
  EXPECT_TRUE(is_usable_after([](RangeScan& scan) { scan.angle_increment = -0.5; }));
  EXPECT_TRUE(is_usable_after([](RangeScan& scan) { scan.T_first_last = planar_pose(1, 0, 1); }));
}

TEST(RangeScan, IsNotUsableWhereItsHeaderMakesNoSense) {
  for (const double odd : {static_cast<double>(kNan), static_cast<double>(kInfinity)}) {
    EXPECT_FALSE(is_usable_after([&](RangeScan& scan) { scan.angle_min = odd; }));
    EXPECT_FALSE(is_usable_after([&](RangeScan& scan) { scan.angle_increment = odd; }));
    EXPECT_FALSE(is_usable_after([&](RangeScan& scan) { scan.range_min = odd; }));
    EXPECT_FALSE(is_usable_after([&](RangeScan& scan) { scan.range_max = odd; }));
    EXPECT_FALSE(
        is_usable_after([&](RangeScan& scan) { scan.T_first_last.translation().x() = odd; }));
  }
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.angle_increment = 0.0; }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.angle_min = -135.0; }));  // degrees
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.angle_increment = 30.0; }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.angle_increment = -1e30; }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.range_min = -0.1; }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.range_max = 0.05; }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.ranges.clear(); }));
  EXPECT_FALSE(is_usable_after([](RangeScan& scan) { scan.T_first_last.linear() *= 2.0; }));
}

TEST(RangeScan, OccupiesItselfAndItsRanges) {
  RangeScan scan = good_scan();
  scan.ranges.reserve(1000);
  EXPECT_EQ(byte_size(scan), sizeof(RangeScan) + scan.ranges.capacity() * sizeof(float));
}

}  // namespace
}  // namespace portolan
