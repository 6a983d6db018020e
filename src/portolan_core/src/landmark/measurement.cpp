// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/limits.hpp"

namespace portolan {

namespace {

double squared(double value) { return value * value; }

double variance(double stated, double otherwise, double sharpest) {
  return squared(std::max(stated > 0.0 ? stated : otherwise, sharpest));
}

Eigen::Vector3d unit_vector(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

Eigen::Vector3d direction(const Measured<PolarModel>& m) { return unit_vector(m.z[1], 0.0); }
Eigen::Vector3d direction(const Measured<SphericalModel>& m) { return unit_vector(m.z[1], m.z[2]); }
Eigen::Vector3d direction(const Measured<AzimuthModel>& m) { return unit_vector(m.z[0], 0.0); }
Eigen::Vector3d direction(const Measured<DirectionModel>& m) { return unit_vector(m.z[0], m.z[1]); }
Eigen::Vector3d direction(const Measured<PixelModel>& m) {
  const PinholeCamera& camera = m.model.camera;
  return Eigen::Vector3d((m.z[0] - camera.cx) / camera.fx, (m.z[1] - camera.cy) / camera.fy, 1.0)
      .normalized();
}

}  // namespace

UncertainSensorPose uncertain(const Pose& T_map_sensor, const std::optional<PoseCovariance>& stated,
                              const LandmarkPoseOptions& options) {
  UncertainSensorPose sensor{T_map_sensor};
  sensor.covariance.diagonal().head<3>().setConstant(squared(options.position_stddev));
  sensor.covariance(5, 5) = squared(options.heading_stddev);
  if (options.stated == StatedCovariance::used && stated && is_stated(*stated))
    sensor.covariance += turned(believable(*stated), T_map_sensor.linear());
  sensor.is_certain = sensor.covariance.isZero(0.0);
  return sensor;
}

Measurement measurement_of(const LandmarkSighting& sighting, const SightingNoiseOptions& noise) {
  const double azimuth = variance(sighting.azimuth_stddev, noise.azimuth_stddev, kSharpestAngle);
  const double elevation =
      variance(sighting.elevation_stddev, noise.elevation_stddev, kSharpestAngle);
  const double range = variance(sighting.range_stddev,
                                noise.range_stddev + noise.range_stddev_per_metre * sighting.range,
                                kSharpestDistance);
  const bool planar = std::isnan(sighting.elevation);
  if (std::isnan(sighting.range)) {
    if (planar)
      return Measured<AzimuthModel>{
          {}, AzimuthModel::Vector(sighting.azimuth), AzimuthModel::Vector(azimuth)};
    return Measured<DirectionModel>{
        {}, {sighting.azimuth, sighting.elevation}, {azimuth, elevation}};
  }
  if (planar) return Measured<PolarModel>{{}, {sighting.range, sighting.azimuth}, {range, azimuth}};
  return Measured<SphericalModel>{
      {}, {sighting.range, sighting.azimuth, sighting.elevation}, {range, azimuth, elevation}};
}

Measurement measurement_of(const ImageFeature& feature, const PinholeCamera& camera,
                           const SightingNoiseOptions& noise) {
  const double pixel = squared(noise.pixel_stddev);
  return Measured<PixelModel>{{{}, camera}, {feature.u, feature.v}, {pixel, pixel}};
}

std::optional<Eigen::Vector3d> shown_point(const Measurement& measurement,
                                           const Pose& T_map_sensor) {
  return std::visit(
      [&](const auto& m) -> std::optional<Eigen::Vector3d> {
        if constexpr (std::decay_t<decltype(m.model)>::kScaleFree) {
          return std::nullopt;
        } else {
          return T_map_sensor * Eigen::Vector3d(m.z[0] * direction(m));
        }
      },
      measurement);
}

Eigen::Vector3d shown_direction(const Measurement& measurement, const Pose& T_map_sensor) {
  return T_map_sensor.linear() *
         std::visit([](const auto& m) { return direction(m); }, measurement);
}

bool tells_height(const Measurement& measurement) {
  return !std::holds_alternative<Measured<PolarModel>>(measurement) &&
         !std::holds_alternative<Measured<AzimuthModel>>(measurement);
}

}  // namespace portolan
