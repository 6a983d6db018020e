// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/thinning.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace portolan {
namespace {

struct Moment {
  double s;
  Pose T_odom_sensor;
  SensorId sensor = 0;
};

/// Which of these moments enter, offered in turn.
std::vector<bool> admitted(const Thinning::Options& options, const std::vector<Moment>& moments) {
  Thinning thinning(options);
  std::vector<bool> entered;
  for (const Moment& moment : moments) {
    const Time stamp(seconds(moment.s));
    entered.push_back(thinning.admits(stamp, moment.T_odom_sensor, moment.sensor));
    if (entered.back()) thinning.remember(stamp, moment.T_odom_sensor, moment.sensor);
  }
  return entered;
}

Thinning::Options thin(double min_travel, double min_turn, double min_interval) {
  Thinning::Options options;
  options.min_travel = min_travel;
  options.min_turn = min_turn;
  options.min_interval = min_interval;
  return options;
}

const Pose kStill = Pose::Identity();
using Entered = std::vector<bool>;

TEST(Thinning, LetsEverythingInByDefault) {
  EXPECT_EQ(admitted({}, {{0.0, kStill}, {0.0, kStill}, {0.1, kStill}}),
            (Entered{true, true, true}));
}

TEST(Thinning, TravelIsMeasuredFromTheLastThatEntered) {
  EXPECT_EQ(admitted(thin(0.5, 0.0, 0.0), {{0, planar_pose(0.0, 0.0, 0)},
                                           {1, planar_pose(0.3, 0.0, 0)},
                                           {2, planar_pose(0.3, 0.4, 0)},
                                           {3, planar_pose(0.3, 0.8, 1)},
                                           {4, planar_pose(0.3, 0.9, 1)}}),
            (Entered{true, false, true, false, true}));
}

TEST(Thinning, TurnIsMeasuredEitherWay) {
  EXPECT_EQ(admitted(thin(0.0, 0.2, 0.0), {{0, planar_pose(0, 0, 3.1)},
                                           {1, planar_pose(5, 0, 3.2)},
                                           {2, planar_pose(5, 0, -2.9)},
                                           {3, planar_pose(5, 0, 3.1)}}),
            (Entered{true, false, true, true}));
}

TEST(Thinning, IntervalIsReachedExactly) {
  EXPECT_EQ(
      admitted(thin(0.0, 0.0, 0.5), {{0, kStill}, {0.25, kStill}, {0.5, kStill}, {0.99, kStill}}),
      (Entered{true, false, true, false}));
}

TEST(Thinning, TheFirstLimitThatIsReachedOpens) {
  EXPECT_EQ(admitted(thin(1.0, 0.5, 10.0), {{0, kStill},
                                            {1, planar_pose(0.9, 0, 0.4)},
                                            {2, planar_pose(1.0, 0, 0.0)},
                                            {3, planar_pose(1.0, 0, 0.6)},
                                            {12, planar_pose(1.0, 0, 0.6)},
                                            {13, planar_pose(1.0, 0, 0.6)}}),
            (Entered{true, false, true, true, false, true}));
}

TEST(Thinning, SensorsAreThinnedApart) {
  EXPECT_EQ(admitted(thin(1.0, 0.0, 0.0), {{0, kStill, 1}, {0, kStill, 2}, {1, kStill, 1}}),
            (Entered{true, true, false}));
}

TEST(Thinning, TimeThatRunsBackOpens) {
  EXPECT_EQ(admitted(thin(1.0, 0.0, 0.0), {{100, kStill}, {5, kStill}, {6, kStill}}),
            (Entered{true, true, false}));
}

TEST(Thinning, WhatWasNotRememberedDoesNotCount) {
  Thinning thinning(thin(1.0, 0.0, 0.0));
  EXPECT_TRUE(thinning.admits(Time(), kStill, 0));
  EXPECT_TRUE(thinning.admits(Time(), kStill, 0));
}

TEST(Thinning, RefusesNegativeLimits) {
  EXPECT_THROW(Thinning(thin(-0.1, 0.0, 0.0)), OptionsError);
}

}  // namespace
}  // namespace portolan
