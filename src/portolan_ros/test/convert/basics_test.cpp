// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/basics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace portolan::ros_convert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

geometry_msgs::Pose message_with(double qx, double qy, double qz, double qw) {
  geometry_msgs::Pose message;
  message.orientation.x = qx;
  message.orientation.y = qy;
  message.orientation.z = qz;
  message.orientation.w = qw;
  return message;
}

TEST(Basics, StampsKeepEveryNanosecond) {
  for (const ros::Time& stamp :
       {ros::Time(0, 1), ros::Time(1700000000, 123456789), ros::TIME_MAX}) {
    EXPECT_EQ(time(time(stamp)), stamp);
  }
  EXPECT_EQ(time(ros::Time(2, 5)), Time(Duration(2000000005)));
}

TEST(Basics, StampsThatNoMessageCanHoldBecomeTheNearest) {
  EXPECT_EQ(time(Time(Duration(-1))), ros::Time(0, 0));
  EXPECT_EQ(time(time(ros::TIME_MAX) + seconds(10.0)), ros::TIME_MAX);
}

TEST(Basics, PosesComeBackAsTheyWere) {
  const Pose there = Eigen::Translation3d(1.0, -2.0, 3.0) *
                     Eigen::AngleAxisd(2.5, Eigen::Vector3d(1.0, 2.0, -2.0).normalized());
  EXPECT_TRUE(pose(pose(there)).isApprox(there, 1e-12));
  EXPECT_TRUE(pose(transform(there)).isApprox(there, 1e-12));
}

TEST(Basics, QuaternionsAreTakenAsXyzw) {
  const double half = std::sqrt(0.5);
  const Pose quarter_turn = pose(message_with(0.0, 0.0, half, half));
  EXPECT_NEAR(yaw(quarter_turn), M_PI_2, 1e-12);
  EXPECT_EQ(quarter_turn.translation(), Eigen::Vector3d::Zero());
}

TEST(Basics, ALengthThatIsOffALittleIsMended) {
  for (const double length : {0.991, 1.0, 1.009}) {
    const Pose mended = pose(message_with(0.0, 0.0, 0.6 * length, 0.8 * length));
    EXPECT_TRUE(is_valid(mended)) << length;
    EXPECT_NEAR(yaw(mended), 2.0 * std::atan2(0.6, 0.8), 1e-12) << length;
  }
}

TEST(Basics, WhatIsNoPoseIsNotValid) {
  EXPECT_FALSE(is_valid(pose(message_with(0.0, 0.0, 0.0, 0.0))));
  EXPECT_FALSE(is_valid(pose(message_with(0.0, 0.0, 0.0, 0.98))));
  EXPECT_FALSE(is_valid(pose(message_with(0.0, 0.0, 0.0, 1.02))));
  EXPECT_FALSE(is_valid(pose(message_with(0.0, kNaN, 0.0, 1.0))));
  for (const double wrong : {kNaN, std::numeric_limits<double>::infinity()}) {
    geometry_msgs::Pose message = message_with(0.0, 0.0, 0.0, 1.0);
    EXPECT_TRUE(is_valid(pose(message)));
    message.position.y = wrong;
    EXPECT_FALSE(is_valid(pose(message)));
  }
}

TEST(Basics, OldNamesLoseTheirSlash) {
  EXPECT_EQ(without_slash("/odom"), "odom");
  EXPECT_EQ(without_slash("odom"), "odom");
  EXPECT_EQ(without_slash("robot/odom"), "robot/odom");
  EXPECT_EQ(without_slash("/"), "");
  EXPECT_EQ(without_slash(""), "");
}

}  // namespace
}  // namespace portolan::ros_convert
