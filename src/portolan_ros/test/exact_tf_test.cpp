// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/exact_tf.hpp"

#include <gtest/gtest.h>

#include <random>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {
namespace {

/// A tf tree odom -> base_link -> laser of which each transform is any at all.
class ExactTf : public testing::Test {
 protected:
  Pose any_pose() {
    std::uniform_real_distribution<double> any(-20.0, 20.0);
    const Eigen::Quaterniond q(any(random), any(random), any(random), any(random));
    return Eigen::Translation3d(any(random), any(random), any(random)) * q.normalized();
  }

  void say(const std::string& parent, const std::string& child, Time stamp, bool is_static) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros_convert::time(stamp);
    transform.child_frame_id = child;
    transform.transform = ros_convert::transform(any_pose());
    ASSERT_TRUE(tf.setTransform(without_last_bits(transform), "test", is_static));
  }

  std::mt19937_64 random{1};
  tf2::BufferCore tf;
};

TEST_F(ExactTf, ThePoseDoesNotDependOnWhatCameLater) {
  say("base_link", "laser", Time{}, true);
  Time stamp(seconds(10.0));
  for (int i = 0; i < 3000; ++i) {
    say("odom", "base_link", stamp, false);
    const auto before = look_up(tf, "odom", "laser", stamp);
    say("odom", "base_link", stamp + seconds(0.003), false);
    const auto after = look_up(tf, "odom", "laser", stamp);
    ASSERT_TRUE(before && after);
    ASSERT_EQ(before->matrix(), after->matrix()) << i;
    stamp += seconds(0.007);
  }
}

TEST_F(ExactTf, AgreesWithTf) {
  say("base_link", "laser", Time{}, true);
  const Time first(seconds(10.0));
  const Time last = first + seconds(0.02);
  say("odom", "base_link", first, false);
  say("odom", "base_link", last, false);
  for (const auto& [target, frame] : {std::pair{"odom", "laser"}, {"laser", "odom"}}) {
    const Time stamp = first + seconds(0.013);
    const auto ours = look_up(tf, target, frame, stamp);
    const Pose theirs =
        ros_convert::pose(tf.lookupTransform(target, frame, ros_convert::time(stamp)).transform);
    ASSERT_TRUE(ours);
    EXPECT_TRUE(ours->isApprox(theirs, 1e-8)) << target;
  }
}

TEST_F(ExactTf, SaysNothingOfWhatTfDoesNotKnow) {
  say("odom", "base_link", Time(seconds(10.0)), false);
  EXPECT_FALSE(look_up(tf, "odom", "base_link", Time(seconds(11.0))));
  EXPECT_FALSE(look_up(tf, "odom", "laser", Time(seconds(10.0))));
  EXPECT_FALSE(look_up(tf, "odom", "", Time(seconds(10.0))));
  EXPECT_FALSE(look_up(tf, "odom", "/base_link", Time(seconds(10.0))));
}

}  // namespace
}  // namespace portolan
