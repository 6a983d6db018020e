// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/pose_history.hpp"

#include <gtest/gtest.h>

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

TEST(PoseHistory, InterpolatesBetweenPosesAndStaysAtTheEnds) {
  PoseHistory history(10s);
  history.add(Time{1s}, planar_pose(1.0, 0.0, 0.0));
  history.add(Time{2s}, planar_pose(2.0, 0.0, 0.4));
  EXPECT_TRUE(history.at(Time{1250ms}).isApprox(planar_pose(1.25, 0.0, 0.1), 1e-12));
  EXPECT_TRUE(history.at(Time{2s}).isApprox(planar_pose(2.0, 0.0, 0.4), 1e-12));
  EXPECT_TRUE(history.at(Time{0s}).isApprox(planar_pose(1.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(history.at(Time{9s}).isApprox(planar_pose(2.0, 0.0, 0.4), 1e-12));
}

TEST(PoseHistory, RemembersItsSpanAndForgetsWhatIsOlder) {
  PoseHistory history(2s);
  for (int i = 0; i <= 10; ++i) history.add(Time{i * 1s}, planar_pose(i, 0.0, 0.0));
  EXPECT_NEAR(history.at(Time{8s}).translation().x(), 8.0, 1e-12);
  EXPECT_GE(history.at(Time{0s}).translation().x(), 7.0);
}

}  // namespace
}  // namespace portolan::sim
