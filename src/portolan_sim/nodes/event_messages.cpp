// SPDX-License-Identifier: BSD-3-Clause
#include "event_messages.hpp"

#include <array>
#include <cstring>

#include "portolan_ros/convert/basics.hpp"

namespace portolan::sim {

namespace {

float narrow(double value) { return static_cast<float>(value); }

geometry_msgs::Twist twist(const Velocity& velocity) {
  geometry_msgs::Twist twist;
  twist.linear.x = velocity.forward;
  twist.angular.z = velocity.turn;
  return twist;
}

/// Fields x, y, z of float32, one after the other.
std::vector<sensor_msgs::PointField> xyz_fields() {
  std::vector<sensor_msgs::PointField> fields;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    fields.push_back(field);
  }
  return fields;
}

}  // namespace

sensor_msgs::LaserScan message(const std_msgs::Header& header, const Event::Scan& z) {
  sensor_msgs::LaserScan scan;
  scan.header = header;
  scan.angle_min = narrow(z.scan.angle_min);
  scan.angle_increment = narrow(z.scan.angle_increment);
  const auto steps = static_cast<double>(z.scan.ranges.size() - 1);
  scan.angle_max = narrow(z.scan.angle_min + steps * z.scan.angle_increment);
  scan.time_increment = narrow(z.time_increment);
  scan.range_min = narrow(z.scan.range_min);
  scan.range_max = narrow(z.scan.range_max);
  scan.ranges = z.scan.ranges;
  return scan;
}

sensor_msgs::Range message(const std_msgs::Header& header, const RangeEcho& z) {
  sensor_msgs::Range range;
  range.header = header;
  range.radiation_type = sensor_msgs::Range::ULTRASOUND;
  range.field_of_view = narrow(z.aperture);
  range.min_range = narrow(z.range_min);
  range.max_range = narrow(z.range_max);
  range.range = narrow(z.range);
  return range;
}

sensor_msgs::PointCloud2 message(const std_msgs::Header& header, const OrganizedCloud& z) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.width = z.width;
  cloud.height = z.height;
  cloud.fields = xyz_fields();
  cloud.point_step = 3 * sizeof(float);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize(z.cloud.points.size() * cloud.point_step);
  for (std::size_t i = 0; i < z.cloud.points.size(); ++i) {
    std::memcpy(&cloud.data[i * cloud.point_step], z.cloud.points[i].data(), cloud.point_step);
  }
  return cloud;
}

portolan_msgs::LandmarkSightings message(const std_msgs::Header& header,
                                         const LandmarkSightings& z) {
  portolan_msgs::LandmarkSightings all;
  all.header = header;
  for (const LandmarkSighting& seen : z.sightings) {
    portolan_msgs::LandmarkSighting sighting;
    sighting.id = seen.id;
    sighting.range = narrow(seen.range);
    sighting.azimuth = narrow(seen.azimuth);
    sighting.elevation = narrow(seen.elevation);
    sighting.range_stddev = narrow(seen.range_stddev);
    sighting.azimuth_stddev = narrow(seen.azimuth_stddev);
    sighting.elevation_stddev = narrow(seen.elevation_stddev);
    all.sightings.push_back(sighting);
  }
  return all;
}

portolan_msgs::ImageFeatures message(const std_msgs::Header& header, const ImageFeatures& z) {
  portolan_msgs::ImageFeatures all;
  all.header = header;
  for (const ImageFeature& seen : z.features) {
    portolan_msgs::ImageFeature feature;
    feature.id = seen.id;
    feature.u = narrow(seen.u);
    feature.v = narrow(seen.v);
    all.features.push_back(feature);
  }
  return all;
}

portolan_msgs::BeaconRanges message(const std_msgs::Header& header, const BeaconRanges& z) {
  portolan_msgs::BeaconRanges all;
  all.header = header;
  for (const BeaconRange& heard : z.ranges) {
    portolan_msgs::BeaconRange range;
    range.id = heard.id;
    range.range = narrow(heard.range);
    range.stddev = narrow(heard.stddev);
    all.ranges.push_back(range);
  }
  return all;
}

nav_msgs::Odometry message(const std_msgs::Header& header, const Event::Odometry& z) {
  nav_msgs::Odometry odometry;
  odometry.header = header;
  odometry.pose.pose = ros_convert::pose(z.T_odom_base);
  odometry.twist.twist = twist(z.velocity);
  constexpr std::array<std::size_t, 3> kPlanar = {0, 1, 5};  // x, y, yaw among the message's six
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      odometry.pose.covariance.at(6 * kPlanar.at(row) + kPlanar.at(column)) =
          z.covariance(static_cast<int>(row), static_cast<int>(column));
    }
  }
  return odometry;
}

nav_msgs::Odometry message(const std_msgs::Header& header, const Event::Truth& z) {
  nav_msgs::Odometry truth;
  truth.header = header;
  truth.pose.pose = ros_convert::pose(z.T_map_base);
  truth.twist.twist = twist(z.velocity);
  return truth;
}

sensor_msgs::CameraInfo camera_info(const std_msgs::Header& header, const Camera::Options& camera) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

}  // namespace portolan::sim
