// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/beacons.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/eigen_messages.hpp"

namespace portolan::ros_convert {

namespace {

portolan_msgs::BeaconMode beacon_mode(const BeaconMode& mode) {
  portolan_msgs::BeaconMode message;
  message.weight = mode.weight;
  message.position = vector<geometry_msgs::Point>(mode.mean);
  fill(mode.covariance, message.covariance);
  return message;
}

portolan_msgs::BeaconDrive beacon_drive(const BeaconDrive& drive) {
  portolan_msgs::BeaconDrive message;
  message.start = vector<geometry_msgs::Point>(drive.p_map);
  message.direction = vector<geometry_msgs::Vector3>(drive.direction);
  message.distance = drive.distance;
  message.expected_information = drive.information;
  return message;
}

portolan_msgs::Beacon beacon(const BeaconEstimate& estimate) {
  portolan_msgs::Beacon message;
  message.id = estimate.id;
  message.ambiguous = estimate.ambiguous;
  message.modes.reserve(estimate.modes.size());
  for (const BeaconMode& mode : estimate.modes) message.modes.push_back(beacon_mode(mode));
  if (estimate.drive) message.drive = beacon_drive(*estimate.drive);
  message.ranges = static_cast<std::uint32_t>(estimate.ranges);
  message.outliers = static_cast<std::uint32_t>(estimate.outliers);
  message.restarts = static_cast<std::uint32_t>(estimate.restarts);
  return message;
}

portolan_msgs::RangeCalibration range_calibration(const RangeCalibration& calibration) {
  portolan_msgs::RangeCalibration message;
  message.scale = calibration.scale;
  message.bias = calibration.bias;
  fill(calibration.covariance.topLeftCorner<2, 2>().eval(), message.covariance);
  message.turn = calibration.turn;
  message.turn_stddev = std::sqrt(calibration.covariance(2, 2));
  return message;
}

}  // namespace

std::optional<Sensed<BeaconRanges>> beacon_ranges(const portolan_msgs::BeaconRanges& message) {
  BeaconRanges z;
  z.ranges.reserve(message.ranges.size());
  for (const portolan_msgs::BeaconRange& range : message.ranges) {
    z.ranges.push_back({range.id, range.range, range.stddev});
  }
  if (!is_usable(z)) return std::nullopt;
  const Time stamp = time(message.header.stamp);
  const std::uint64_t part = part_about(z.ranges);
  return Sensed<BeaconRanges>{message.header.frame_id, stamp, stamp, std::move(z), part};
}

portolan_msgs::BeaconMap beacon_map(const BeaconMapper& mapper) {
  portolan_msgs::BeaconMap message;
  for (const BeaconEstimate& estimate : mapper.estimates()) {
    message.beacons.push_back(beacon(estimate));
  }
  message.calibration = range_calibration(mapper.calibration());
  message.drift = mapper.drift();
  message.noise = mapper.noise();
  message.ranges_taken = mapper.counts().taken;
  message.ranges_malformed = mapper.counts().malformed;
  message.ranges_too_long = mapper.counts().too_long;
  message.ranges_refused = mapper.counts().refused;
  return message;
}

}  // namespace portolan::ros_convert
