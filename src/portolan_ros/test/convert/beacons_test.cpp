// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/beacons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "portolan_ros/convert/beacon_markers.hpp"

namespace portolan::ros_convert {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

portolan_msgs::BeaconRange range(std::uint32_t id, float value, float stddev = 0.125F) {
  portolan_msgs::BeaconRange message;
  message.id = id;
  message.range = value;
  message.stddev = stddev;
  return message;
}

portolan_msgs::BeaconRanges ranges_message() {
  portolan_msgs::BeaconRanges message;
  message.header.frame_id = "antenna";
  message.header.stamp = ros::Time(12, 500000000);
  message.ranges = {range(7, 2.5F), range(3, 4.0F, 0.0F)};
  return message;
}

/// Beacon 1 is heard from a straight line, on either side of which it may stand; beacon 2 from all
/// around.
BeaconMapper two_beacons() {
  BeaconMapper mapper{BeaconOptions{}};
  for (int i = 0; i < 12; ++i) {
    const Pose pose = planar_pose(0.5 * i, 0.0, 0.0);
    mapper.insert({{{1, (Eigen::Vector3d(3.0, 2.0, 0.0) - pose.translation()).norm(), 0.1}}}, pose);
  }
  for (int i = 0; i < 40; ++i) {
    const Pose pose = planar_pose(4.0 * std::cos(0.2 * i), 4.0 * std::sin(0.2 * i), 0.0);
    mapper.insert({{{2, (Eigen::Vector3d(1.0, 1.0, 0.0) - pose.translation()).norm(), 0.1}}}, pose);
  }
  return mapper;
}

TEST(BeaconRangesMessage, BecomesWhatTheSensorSays) {
  const std::optional<Sensed<BeaconRanges>> sensed = beacon_ranges(ranges_message());
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->frame, "antenna");
  EXPECT_EQ(sensed->first, Time(Duration(12500000000)));
  EXPECT_EQ(sensed->last, sensed->first);
  ASSERT_EQ(sensed->z.ranges.size(), 2u);
  EXPECT_EQ(sensed->z.ranges[0].id, 7u);
  EXPECT_EQ(sensed->z.ranges[0].range, 2.5);
  EXPECT_EQ(sensed->z.ranges[0].stddev, 0.125);
  EXPECT_EQ(sensed->z.ranges[1].id, 3u);
  EXPECT_EQ(sensed->z.ranges[1].stddev, 0.0);
}

TEST(BeaconRangesMessage, IsMalformedOnlyWhereAllRangesAre) {
  portolan_msgs::BeaconRanges message = ranges_message();
  message.ranges = {range(1, kNaN),
                    range(2, -1.0F),
                    range(3, 0.0F),
                    range(4, 1.0F, -0.1F),
                    range(5, std::numeric_limits<float>::infinity()),
                    range(6, 1.0F, kNaN)};
  EXPECT_FALSE(beacon_ranges(message));
  message.ranges.push_back(range(7, 1.0F));
  const std::optional<Sensed<BeaconRanges>> sensed = beacon_ranges(message);
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->z.ranges.size(), 7u);  // the mapper counts the others
  message.ranges.clear();
  EXPECT_TRUE(beacon_ranges(message));
}

TEST(BeaconRangesMessage, TellsRepetitionsFromOtherBeaconsOfTheSameMoment) {
  const auto part = [](const portolan_msgs::BeaconRanges& message) {
    return beacon_ranges(message)->part;
  };
  portolan_msgs::BeaconRanges one = ranges_message();
  portolan_msgs::BeaconRanges other = ranges_message();
  EXPECT_EQ(part(one), part(other));
  one.ranges = {range(1, 2.0F)};
  other.ranges = {range(2, 2.0F)};
  EXPECT_NE(part(one), part(other));
}

TEST(BeaconMapMessage, SaysAllThatTheMapperKnows) {
  const BeaconMapper mapper = two_beacons();
  const std::vector<BeaconEstimate> estimates = mapper.estimates();
  const portolan_msgs::BeaconMap map = beacon_map(mapper);
  ASSERT_EQ(map.beacons.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const portolan_msgs::Beacon& beacon = map.beacons[i];
    EXPECT_EQ(beacon.id, estimates[i].id);
    EXPECT_EQ(beacon.ambiguous, estimates[i].ambiguous);
    EXPECT_EQ(beacon.ranges, estimates[i].ranges);
    ASSERT_EQ(beacon.modes.size(), estimates[i].modes.size());
    for (std::size_t m = 0; m < beacon.modes.size(); ++m) {
      const BeaconMode& mode = estimates[i].modes[m];
      EXPECT_EQ(beacon.modes[m].weight, mode.weight);
      EXPECT_EQ(beacon.modes[m].position.x, mode.mean.x());
      EXPECT_EQ(beacon.modes[m].position.y, mode.mean.y());
      for (int k = 0; k < 9; ++k) {
        EXPECT_EQ(beacon.modes[m].covariance[static_cast<std::size_t>(k)],
                  mode.covariance(k / 3, k % 3));
      }
    }
  }
  EXPECT_EQ(map.calibration.scale, mapper.calibration().scale);
  EXPECT_EQ(map.calibration.bias, mapper.calibration().bias);
  EXPECT_EQ(map.calibration.covariance[1], mapper.calibration().covariance(0, 1));
  EXPECT_EQ(map.calibration.covariance[3], mapper.calibration().covariance(1, 1));
  EXPECT_EQ(map.drift, mapper.drift());
  EXPECT_EQ(map.noise, mapper.noise());
}

TEST(BeaconMapMessage, SaysWhereToDriveForTheAmbiguousOne) {
  const portolan_msgs::BeaconMap map = beacon_map(two_beacons());
  ASSERT_TRUE(map.beacons[0].ambiguous);
  ASSERT_FALSE(map.beacons[1].ambiguous);
  const portolan_msgs::BeaconDrive& drive = map.beacons[0].drive;
  EXPECT_EQ(drive.start.x, 5.5);
  EXPECT_NEAR(std::hypot(drive.direction.x, drive.direction.y), 1.0, 1e-12);
  EXPECT_GT(std::abs(drive.direction.y), 0.3);
  EXPECT_GT(drive.expected_information, 0.2);
  EXPECT_GT(drive.distance, 0.0);
}

TEST(BeaconMapMessage, Counts) {
  BeaconOptions options;
  options.max_beacons = 2;
  options.outliers.max_range = 50.0;
  BeaconMapper mapper(options);
  mapper.insert({{{1, 2.0, 0.1}, {2, -2.0, 0.1}, {3, 2.0, 0.1}, {4, 2.0, 0.1}, {1, 60.0, 0.1}}},
                Pose::Identity());
  const portolan_msgs::BeaconMap map = beacon_map(mapper);
  EXPECT_EQ(map.ranges_taken, 2u);
  EXPECT_EQ(map.ranges_malformed, 1u);
  EXPECT_EQ(map.ranges_refused, 1u);
  EXPECT_EQ(map.ranges_too_long, 1u);
}

TEST(BeaconMarkers, ShowEveryModeTheHeavierTheStronger) {
  portolan_msgs::BeaconMap map;
  map.header.frame_id = "map";
  map.beacons.resize(1);
  map.beacons[0].id = 42;
  map.beacons[0].ambiguous = true;
  map.beacons[0].modes.resize(2);
  map.beacons[0].modes[0].weight = 0.75;
  map.beacons[0].modes[0].position.x = 3.0;
  map.beacons[0].modes[0].covariance = {0.04, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0};
  map.beacons[0].modes[1] = map.beacons[0].modes[0];
  map.beacons[0].modes[1].weight = 0.25;
  map.beacons[0].drive.direction.y = 1.0;
  map.beacons[0].drive.distance = 2.0;
  const std::vector<visualization_msgs::Marker> markers = beacon_markers(map, 2.0).markers;
  using visualization_msgs::Marker;
  ASSERT_EQ(markers.size(), 5u);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  for (const Marker& marker : markers) EXPECT_EQ(marker.header.frame_id, "map");
  EXPECT_EQ(markers[1].pose.position.x, 3.0);
  std::array<double, 3> sizes = {markers[1].scale.x, markers[1].scale.y, markers[1].scale.z};
  std::sort(sizes.begin(), sizes.end());
  EXPECT_GT(sizes[0], 0.0);           // flat ones are not drawn
  EXPECT_NEAR(sizes[1], 0.4, 1e-12);  // 2 deviations of 0.1 m either way
  EXPECT_NEAR(sizes[2], 0.8, 1e-12);
  EXPECT_GT(markers[1].color.a, 2.0F * markers[2].color.a);
  EXPECT_GT(markers[2].color.a, 0.0F);
  EXPECT_EQ(markers[3].text, "42?");
  ASSERT_EQ(markers[4].points.size(), 2u);
  EXPECT_EQ(markers[4].points[1].y, 2.0);
}

TEST(BeaconMarkers, TurnTheEllipsoidAsTheCovarianceLies) {
  portolan_msgs::BeaconMap map;
  map.beacons.resize(1);
  map.beacons[0].modes.resize(1);
  map.beacons[0].modes[0].weight = 1.0;
  map.beacons[0].modes[0].covariance = {0.05, 0.04, 0.0, 0.04, 0.05, 0.0, 0.0, 0.0, 0.0};
  const visualization_msgs::Marker marker = beacon_markers(map, 1.0).markers.at(1);
  const auto& o = marker.pose.orientation;
  const Eigen::Matrix3d axes = Eigen::Quaterniond(o.w, o.x, o.y, o.z).toRotationMatrix();
  const Eigen::Vector3d half(marker.scale.x / 2.0, marker.scale.y / 2.0, marker.scale.z / 2.0);
  const Eigen::Matrix3d drawn = axes * half.cwiseAbs2().asDiagonal() * axes.transpose();
  EXPECT_NEAR(drawn(0, 0), 0.05, 1e-9);
  EXPECT_NEAR(drawn(0, 1), 0.04, 1e-9);
  EXPECT_NEAR(drawn(1, 1), 0.05, 1e-9);
}

}  // namespace
}  // namespace portolan::ros_convert
