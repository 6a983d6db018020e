// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/correction.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "portolan_ros/convert/basics.hpp"

namespace portolan::ros_convert {
namespace {

Correction two_knots() {
  return Correction({{Time(seconds(1.0)), planar_pose(0.5, 0.0, 0.1)},
                     {Time(seconds(2.0)), planar_pose(1.0, -0.5, 0.3)}});
}

portolan_msgs::DriftCorrection message() { return correction(two_knots(), "map", "odom"); }

TEST(CorrectionMessage, NamesItsFrames) {
  EXPECT_EQ(message().header.frame_id, "map");
  EXPECT_EQ(message().child_frame_id, "odom");
}

TEST(CorrectionMessage, ComesBackAsItWas) {
  const Correction back = correction(message(), "map", "odom");
  ASSERT_EQ(back.knots().size(), 2u);
  for (const double t : {0.0, 1.0, 1.25, 2.0, 9.0}) {
    const Time stamp(seconds(t));
    EXPECT_TRUE(back.at(stamp).isApprox(two_knots().at(stamp), 1e-12)) << t;
  }
}

TEST(CorrectionMessage, WithoutKnotsIsNoDrift) {
  const Correction none = correction(correction(Correction(), "map", "odom"), "map", "odom");
  EXPECT_TRUE(none.knots().empty());
  EXPECT_EQ(none.at(Time(seconds(5.0))).matrix(), Pose::Identity().matrix());
}

TEST(CorrectionMessage, AboutAnotherFrameIsRefused) {
  EXPECT_THROW(correction(message(), "map", "wheels"), std::invalid_argument);
  auto wrong = message();
  wrong.child_frame_id.clear();
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
  wrong.child_frame_id = "/odom";  // an old name is the same frame
  EXPECT_NO_THROW(correction(wrong, "map", "odom"));
  EXPECT_NO_THROW(correction(message(), "/map", "/odom"));
}

TEST(CorrectionMessage, OfAnotherMapIsRefused) {
  EXPECT_THROW(correction(message(), "robot_1/map", "odom"), std::invalid_argument);
  auto unnamed = message();
  unnamed.header.frame_id.clear();
  EXPECT_NO_THROW(correction(unnamed, "robot_1/map", "odom"));
}

TEST(CorrectionMessage, WithUnequalNumbersIsRefused) {
  auto wrong = message();
  wrong.stamps.pop_back();
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
  wrong = message();
  wrong.poses.clear();
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
}

TEST(CorrectionMessage, WhoseStampsDoNotIncreaseIsRefused) {
  auto wrong = message();
  wrong.stamps[1] = wrong.stamps[0];
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
  wrong.stamps[1] = ros::Time(0, 5);
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
}

TEST(CorrectionMessage, WithAPoseThatIsNoneIsRefused) {
  auto wrong = message();
  wrong.poses[1].orientation.w = 2.0;
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
  wrong = message();
  wrong.poses[0].position.z = std::numeric_limits<double>::infinity();
  EXPECT_THROW(correction(wrong, "map", "odom"), std::invalid_argument);
}

}  // namespace
}  // namespace portolan::ros_convert
