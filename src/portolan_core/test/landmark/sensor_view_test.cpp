// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/sensor_view.hpp"

#include <gtest/gtest.h>

namespace portolan {
namespace {

TEST(SensorView, KnowsNothingAtFirst) { EXPECT_EQ(SensorView().p_detection({3.0, 0.0, 0.0}), 0.0); }

TEST(SensorView, LearnsWhereItSeesAndWhereNot) {
  SensorView view;
  for (int i = 0; i < 40; ++i) {
    view.note({3.0, 0.0, 0.0}, true);
    view.note({-3.0, 0.0, 0.0}, false);
  }
  EXPECT_GT(view.p_detection({3.0, 0.0, 0.0}), 0.8);
  EXPECT_EQ(view.p_detection({-3.0, 0.0, 0.0}), 0.0);
}

// What looks through a place would have seen what is there.
TEST(SensorView, SeesWhatIsNearerThanWhatItSees) {
  SensorView view;
  for (int i = 0; i < 40; ++i) view.note({6.0, 0.0, 0.0}, true);
  EXPECT_GT(view.p_detection({1.5, 0.0, 0.0}), 0.8);
  EXPECT_EQ(view.p_detection({0.0, 1.5, 0.0}), 0.0);
  EXPECT_EQ(view.p_detection({20.0, 0.0, 0.0}), 0.0);
  for (int i = 0; i < 40; ++i) view.note({1.5, 0.0, 0.0}, false);
  EXPECT_EQ(view.p_detection({1.5, 0.0, 0.0}), 0.0) << "it knows better there";
}

TEST(SensorView, IsNewsWhenItMovedOrTurned) {
  SensorView view;
  EXPECT_TRUE(view.is_news(Pose::Identity()));
  EXPECT_FALSE(view.is_news(planar_pose(0.1, 0.0, 0.05)));
  EXPECT_TRUE(view.is_news(planar_pose(0.4, 0.0, 0.0)));
  EXPECT_TRUE(view.is_news(planar_pose(0.4, 0.0, 0.3)));
}

}  // namespace
}  // namespace portolan
