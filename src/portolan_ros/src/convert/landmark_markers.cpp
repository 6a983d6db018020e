// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/landmark_markers.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "portolan_ros/convert/eigen_messages.hpp"

namespace portolan::ros_convert {

namespace {

using portolan_msgs::Landmark;
using visualization_msgs::Marker;

Marker marker(const portolan_msgs::LandmarkMap& map, const char* name, std::int32_t type,
              const Landmark& landmark) {
  Marker marker;
  marker.header = map.header;
  marker.ns = name;
  marker.id = landmark.id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  const bool is_point = landmark.kind == Landmark::POINT;
  marker.color.r = is_point ? 0.10F : 0.90F;
  marker.color.g = is_point ? 0.40F : 0.45F;
  marker.color.b = is_point ? 0.85F : 0.05F;
  marker.color.a = 0.2F + 0.7F * static_cast<float>(landmark.existence);
  return marker;
}

Marker ellipsoid(const portolan_msgs::LandmarkMap& map, const Landmark& landmark,
                 double standard_deviations) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Marker ellipsoid = marker(map, "landmarks", Marker::SPHERE, landmark);
  ellipsoid.color.a *= 0.5F;
  const Eigen::Matrix3d covariance = Eigen::Map<const RowMajor>(landmark.covariance.data());
  fill_ellipsoid(landmark.position, covariance, standard_deviations, ellipsoid);
  return ellipsoid;
}

/// Where it most likely is: the ellipsoid of a landmark that is known well is too small to be seen.
Marker dot(const portolan_msgs::LandmarkMap& map, const Landmark& landmark) {
  Marker dot = marker(map, "places", Marker::SPHERE, landmark);
  dot.pose.position = landmark.position;
  dot.scale.x = dot.scale.y = dot.scale.z = 0.12;
  return dot;
}

/// From where it was first seen to where it most likely is.
Marker ray(const portolan_msgs::LandmarkMap& map, const Landmark& landmark) {
  Marker ray = marker(map, "rays", Marker::LINE_STRIP, landmark);
  ray.points = {landmark.ray.position, landmark.position};
  ray.scale.x = 0.02;
  return ray;
}

Marker arrow(const portolan_msgs::LandmarkMap& map, const Landmark& landmark) {
  constexpr double kLength = 2.0;  // [m]
  Marker arrow = marker(map, "directions", Marker::ARROW, landmark);
  const auto& p = landmark.position;
  const auto& o = landmark.ray.position;
  const Eigen::Vector3d direction = Eigen::Vector3d(p.x - o.x, p.y - o.y, p.z - o.z).normalized();
  arrow.points.assign(2, o);
  arrow.points[1].x += kLength * direction.x();
  arrow.points[1].y += kLength * direction.y();
  arrow.points[1].z += kLength * direction.z();
  arrow.scale.x = 0.04;
  arrow.scale.y = 0.1;
  arrow.scale.z = 0.15;
  return arrow;
}

Marker label(const portolan_msgs::LandmarkMap& map, const Landmark& landmark) {
  Marker text = marker(map, "ids", Marker::TEXT_VIEW_FACING, landmark);
  text.pose.position = landmark.position;
  text.pose.position.z += 0.3;
  text.scale.z = 0.25;
  text.text = std::to_string(landmark.id);
  return text;
}

}  // namespace

visualization_msgs::MarkerArray landmark_markers(const portolan_msgs::LandmarkMap& map,
                                                 double standard_deviations) {
  visualization_msgs::MarkerArray all;
  all.markers.push_back(marker(map, "", Marker::CUBE, Landmark{}));
  all.markers.back().action = Marker::DELETEALL;
  for (const Landmark& landmark : map.landmarks) {
    if (landmark.kind == Landmark::DIRECTION) {
      all.markers.push_back(arrow(map, landmark));
      continue;
    }
    if (landmark.kind == Landmark::RAY) all.markers.push_back(ray(map, landmark));
    all.markers.push_back(dot(map, landmark));
    all.markers.push_back(ellipsoid(map, landmark, standard_deviations));
    all.markers.push_back(label(map, landmark));
  }
  return all;
}

}  // namespace portolan::ros_convert
