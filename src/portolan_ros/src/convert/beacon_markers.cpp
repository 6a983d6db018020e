// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/beacon_markers.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>

#include "portolan_ros/convert/eigen_messages.hpp"

namespace portolan::ros_convert {

namespace {

using visualization_msgs::Marker;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr float kFaintest = 0.08F;  // opacity of a mode without weight

std_msgs::ColorRGBA colour(const portolan_msgs::Beacon& beacon, float opacity) {
  std_msgs::ColorRGBA colour;
  colour.r = beacon.ambiguous ? 0.90F : 0.10F;
  colour.g = beacon.ambiguous ? 0.45F : 0.55F;
  colour.b = beacon.ambiguous ? 0.05F : 0.25F;
  colour.a = opacity;
  return colour;
}

Marker marker(const portolan_msgs::BeaconMap& map, const char* name, std::int32_t type,
              std::size_t id) {
  Marker marker;
  marker.header = map.header;
  marker.ns = name;
  marker.id = static_cast<std::int32_t>(id);
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker label(const portolan_msgs::BeaconMap& map, const portolan_msgs::Beacon& beacon,
             std::size_t id) {
  Marker text = marker(map, "ids", Marker::TEXT_VIEW_FACING, id);
  text.pose.position = beacon.modes.front().position;
  text.pose.position.z += 0.5;
  text.scale.z = 0.4;
  text.color.a = 1.0F;  // black: readable on its own ellipsoid
  text.text = std::to_string(beacon.id) + (beacon.ambiguous ? "?" : "");
  return text;
}

bool has_direction(const portolan_msgs::BeaconDrive& drive) { return drive.distance > 0.0; }

Marker arrow(const portolan_msgs::BeaconMap& map, const portolan_msgs::Beacon& beacon,
             std::size_t id) {
  const portolan_msgs::BeaconDrive& drive = beacon.drive;
  Marker arrow = marker(map, "drives", Marker::ARROW, id);
  arrow.points.assign(2, drive.start);
  arrow.points[1].x += drive.distance * drive.direction.x;
  arrow.points[1].y += drive.distance * drive.direction.y;
  arrow.points[1].z += drive.distance * drive.direction.z;
  arrow.scale.x = 0.06;
  arrow.scale.y = 0.16;
  arrow.scale.z = 0.2;
  arrow.color = colour(beacon, 0.9F);
  return arrow;
}

}  // namespace

visualization_msgs::MarkerArray beacon_markers(const portolan_msgs::BeaconMap& map,
                                               double standard_deviations) {
  visualization_msgs::MarkerArray all;
  all.markers.push_back(marker(map, "", Marker::CUBE, 0));
  all.markers.back().action = Marker::DELETEALL;
  for (const portolan_msgs::Beacon& beacon : map.beacons) {
    if (beacon.modes.empty()) continue;
    for (const portolan_msgs::BeaconMode& mode : beacon.modes) {
      Marker ellipsoid = marker(map, "modes", Marker::SPHERE, all.markers.size());
      const Eigen::Matrix3d covariance = Eigen::Map<const RowMajor>(mode.covariance.data());
      fill_ellipsoid(mode.position, covariance, standard_deviations, ellipsoid);
      ellipsoid.color =
          colour(beacon, kFaintest + (1.0F - kFaintest) * static_cast<float>(mode.weight));
      all.markers.push_back(ellipsoid);
    }
    all.markers.push_back(label(map, beacon, all.markers.size()));
    if (has_direction(beacon.drive)) {
      all.markers.push_back(arrow(map, beacon, all.markers.size()));
    }
  }
  return all;
}

}  // namespace portolan::ros_convert
