// SPDX-License-Identifier: BSD-3-Clause
// Sensor messages of any content: what a conversion lets through, a mapper takes or refuses.
#include <algorithm>
#include <cmath>

#include "fuzz.hpp"
#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/grid/grid_mapper.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan_ros/convert/beacons.hpp"
#include "portolan_ros/convert/correction.hpp"
#include "portolan_ros/convert/point_cloud.hpp"
#include "portolan_ros/convert/ranges.hpp"

namespace portolan::fuzz {
namespace {

sensor_msgs::LaserScan scan(Bytes bytes) {
  sensor_msgs::LaserScan message;
  bytes.fill(message.header.stamp.sec);
  bytes.fill(message.header.stamp.nsec);
  for (float* value : {&message.angle_min, &message.angle_increment, &message.time_increment,
                       &message.range_min, &message.range_max}) {
    bytes.fill(*value);
  }
  message.ranges = bytes.all<float>();
  return message;
}

sensor_msgs::Range echo(Bytes bytes) {
  sensor_msgs::Range message;
  for (float* value :
       {&message.field_of_view, &message.min_range, &message.max_range, &message.range}) {
    bytes.fill(*value);
  }
  return message;
}

sensor_msgs::PointCloud2 cloud(Bytes bytes) {
  sensor_msgs::PointCloud2 message;
  for (std::uint32_t* value :
       {&message.width, &message.height, &message.point_step, &message.row_step}) {
    *value = bytes.next<std::uint8_t>() == 255 ? bytes.next<std::uint32_t>()
                                               : bytes.next<std::uint8_t>();
  }
  message.is_bigendian = bytes.next<std::uint8_t>() % 2;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = bytes.next<std::uint8_t>();
    if (field.offset == 255) field.offset = bytes.next<std::uint32_t>();
    field.datatype = bytes.next<std::uint8_t>() % 10;
    field.count = bytes.next<std::uint8_t>();
    message.fields.push_back(field);
  }
  message.data = bytes.all<std::uint8_t>();
  return message;
}

portolan_msgs::DriftCorrection drift(Bytes bytes) {
  portolan_msgs::DriftCorrection message;
  message.child_frame_id = "odom";
  message.stamps.resize(bytes.next<std::uint8_t>() % 8);
  message.poses.resize(bytes.next<std::uint8_t>() % 8);
  for (ros::Time& stamp : message.stamps) {
    bytes.fill(stamp.sec);
    bytes.fill(stamp.nsec);
  }
  for (geometry_msgs::Pose& pose : message.poses) {
    for (double* value : {&pose.position.x, &pose.position.y, &pose.position.z, &pose.orientation.x,
                          &pose.orientation.y, &pose.orientation.z, &pose.orientation.w}) {
      bytes.fill(*value);
    }
  }
  return message;
}

portolan_msgs::BeaconRanges ranges(Bytes bytes) {
  portolan_msgs::BeaconRanges message;
  message.ranges.resize(bytes.next<std::uint8_t>() % 8);
  for (portolan_msgs::BeaconRange& range : message.ranges) {
    bytes.fill(range.id);
    bytes.fill(range.range);
    bytes.fill(range.stddev);
  }
  return message;
}

// A small map: what is far out is refused, so that no input takes long.
template <class Mapper, class Z>
void map(const Z& z) {
  typename Mapper::Options options;
  options.resolution = 0.5;
  insert_twice(Mapper(options), z);
}

bool is_finite(const BeaconEstimate& beacon) {
  return std::all_of(beacon.modes.begin(), beacon.modes.end(), [](const BeaconMode& mode) {
    return std::isfinite(mode.weight) && mode.mean.allFinite() && mode.covariance.allFinite();
  });
}

void map_beacons(const BeaconRanges& z) {
  for (const BeaconEstimate& beacon : insert_twice(BeaconMapper({}), z).estimates()) {
    if (!is_finite(beacon)) fail("a beacon that is nowhere");
  }
}

void convert(std::uint8_t kind, Bytes bytes) {
  switch (kind % 5) {
    case 0:
      if (const auto sensed = ros_convert::range_scan(scan(bytes))) {
        map<GridMapper>(sensed->z);
        map<OctoMapper>(sensed->z);
      }
      return;
    case 1:
      if (const auto sensed = ros_convert::range_echo(echo(bytes))) map<GridMapper>(sensed->z);
      return;
    case 2:
      if (const auto sensed = ros_convert::point_cloud(cloud(bytes))) {
        map<GridMapper>(sensed->z);
        map<OctoMapper>(sensed->z);
      }
      if (const auto sensed = ros_convert::organized_cloud(cloud(bytes))) {
        map<OctoMapper>(sensed->z.cloud);
      }
      return;
    case 3:
      if (const auto sensed = ros_convert::beacon_ranges(ranges(bytes))) map_beacons(sensed->z);
      return;
    default:
      try {
        const Correction read = ros_convert::correction(drift(bytes), "map", "odom");
        if (!is_valid(read.at(Time(seconds(1.0))))) fail("a correction that is no rigid motion");
      } catch (const std::invalid_argument&) {
      }
  }
}

}  // namespace
}  // namespace portolan::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) portolan::fuzz::convert(data[0], {data + 1, size - 1});
  return 0;
}
