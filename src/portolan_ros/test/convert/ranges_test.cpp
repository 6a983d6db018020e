// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace portolan::ros_convert {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

sensor_msgs::LaserScan scan_message() {
  sensor_msgs::LaserScan message;
  message.header.frame_id = "/laser";
  message.header.stamp = ros::Time(12, 500000000);
  message.angle_min = -0.5F;
  message.angle_max = 0.5F;
  message.angle_increment = 0.25F;
  message.time_increment = 0.125F;
  message.range_min = 0.25F;
  message.range_max = 8.0F;
  message.ranges = {1.0F, kInf, kNaN, 0.0F, 7.5F};
  return message;
}

sensor_msgs::Range range_message() {
  sensor_msgs::Range message;
  message.header.frame_id = "sonar_3";
  message.header.stamp = ros::Time(12, 0);
  message.field_of_view = 0.5F;
  message.min_range = 0.25F;
  message.max_range = 4.0F;
  message.range = 2.0F;
  return message;
}

TEST(RangeScanMessage, SaysWhatTheSensorSaidAndWhen) {
  const auto sensed = range_scan(scan_message());
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->frame, "/laser");
  EXPECT_EQ(sensed->first, Time(seconds(12.5)));
  EXPECT_EQ(sensed->last, Time(seconds(13.0)));  // four steps of an eighth
  EXPECT_EQ(sensed->z.angle_min, -0.5);
  EXPECT_EQ(sensed->z.angle_increment, 0.25);
  EXPECT_EQ(sensed->z.range_min, 0.25);
  EXPECT_EQ(sensed->z.range_max, 8.0);
  ASSERT_EQ(sensed->z.ranges.size(), 5u);
  EXPECT_EQ(sensed->z.ranges[0], 1.0F);
  EXPECT_EQ(sensed->z.ranges[1], kInf);
  EXPECT_TRUE(std::isnan(sensed->z.ranges[2]));
}

TEST(RangeScanMessage, WithOneBeamOrWithoutTimesTakesNoTime) {
  sensor_msgs::LaserScan message = scan_message();
  message.time_increment = 0.0F;
  EXPECT_EQ(range_scan(message)->last, range_scan(message)->first);
  message = scan_message();
  message.ranges.resize(1);
  EXPECT_EQ(range_scan(message)->last, range_scan(message)->first);
}

TEST(RangeScanMessage, MayTurnClockwiseAndHaveEqualLimits) {
  sensor_msgs::LaserScan message = scan_message();
  message.angle_increment = -0.25F;
  message.range_min = message.range_max;
  EXPECT_TRUE(range_scan(message));
}

TEST(RangeScanMessage, MayHaveNoUpperLimit) {
  sensor_msgs::LaserScan message = scan_message();
  message.range_max = kInf;
  const auto sensed = range_scan(message);
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->z.range_max, std::numeric_limits<float>::max());
}

TEST(RangeScanMessage, ThatIsMalformedIsNone) {
  using Message = sensor_msgs::LaserScan;
  const std::vector<std::function<void(Message&)>> spoil = {
      [](Message& m) { m.ranges.clear(); },         [](Message& m) { m.angle_increment = 0.0F; },
      [](Message& m) { m.angle_increment = kNaN; }, [](Message& m) { m.angle_min = kInf; },
      [](Message& m) { m.range_min = 9.0F; },       [](Message& m) { m.range_min = kNaN; },
      [](Message& m) { m.range_min = -1.0F; },      [](Message& m) { m.range_max = -kInf; },
      [](Message& m) { m.range_max = kNaN; },       [](Message& m) { m.time_increment = -0.01F; },
      [](Message& m) { m.time_increment = 2.6F; },  [](Message& m) { m.time_increment = kNaN; },
      [](Message& m) { m.time_increment = kInf; },  [](Message& m) { m.time_increment = 3e38F; },
  };
  for (std::size_t i = 0; i < spoil.size(); ++i) {
    Message message = scan_message();
    spoil[i](message);
    EXPECT_FALSE(range_scan(message)) << i;
  }
}

TEST(RangeMessage, SaysWhatTheSensorSaidAndWhen) {
  const auto sensed = range_echo(range_message());
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->frame, "sonar_3");
  EXPECT_EQ(sensed->first, Time(seconds(12.0)));
  EXPECT_EQ(sensed->last, sensed->first);
  EXPECT_EQ(sensed->z.range, 2.0);
  EXPECT_EQ(sensed->z.range_min, 0.25);
  EXPECT_EQ(sensed->z.range_max, 4.0);
  EXPECT_EQ(sensed->z.aperture, 0.5);
}

TEST(RangeMessage, MayHoldAnyRange) {
  for (const float range : {kNaN, kInf, -kInf, 0.0F, -1.0F, 100.0F}) {
    sensor_msgs::Range message = range_message();
    message.range = range;
    EXPECT_TRUE(range_echo(message)) << range;
  }
}

TEST(RangeMessage, OfAFixedDistanceRangerIsUsable) {
  sensor_msgs::Range message = range_message();
  message.min_range = message.max_range;
  EXPECT_TRUE(range_echo(message));
}

TEST(RangeMessage, MayHaveNoUpperLimit) {
  sensor_msgs::Range message = range_message();
  message.max_range = kInf;
  ASSERT_TRUE(range_echo(message));
}

TEST(RangeMessage, ThatIsMalformedIsNone) {
  using Message = sensor_msgs::Range;
  const std::vector<std::function<void(Message&)>> spoil = {
      [](Message& m) { m.field_of_view = 0.0F; }, [](Message& m) { m.field_of_view = kNaN; },
      [](Message& m) { m.field_of_view = 7.0F; }, [](Message& m) { m.min_range = 5.0F; },
      [](Message& m) { m.min_range = -1.0F; },    [](Message& m) { m.min_range = kNaN; },
      [](Message& m) { m.max_range = -kInf; },    [](Message& m) { m.max_range = kNaN; },
  };
  for (std::size_t i = 0; i < spoil.size(); ++i) {
    Message message = range_message();
    spoil[i](message);
    EXPECT_FALSE(range_echo(message)) << i;
  }
}

}  // namespace
}  // namespace portolan::ros_convert
