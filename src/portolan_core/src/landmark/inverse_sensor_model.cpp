// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/inverse_sensor_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "portolan/landmark/inverse_depth.hpp"

namespace portolan {

namespace {

double squared(double value) { return value * value; }

/// The sensor's frame turned so that x points along the direction l, and y as level as it was.
Eigen::Matrix3d turned_to(const Eigen::Vector3d& l) {
  const double azimuth = std::atan2(l.y(), l.x());
  const double elevation = std::atan2(l.z(), l.head<2>().norm());
  return (Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(-elevation, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

/// Axes of a camera's optical frame from those of REP 103: z forward is x, x right is -y.
Eigen::Matrix3d optical_from_level() {
  return (Eigen::Matrix3d() << 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0).finished();
}

Place point_at(const Eigen::Vector3d& l, const Eigen::Matrix3d& covariance_in_sensor,
               const UncertainSensorPose& sensor) {
  const Eigen::Matrix3d R = sensor.T_map_sensor.linear();
  Place place;
  place.mean = sensor.T_map_sensor * l;
  place.covariance = R * covariance_in_sensor * R.transpose() +
                     carried(sensor.covariance, R * l).topLeftCorner<3, 3>();
  place.covariance = (0.5 * (place.covariance + place.covariance.transpose())).eval();
  return place;
}

/// What the pose's errors make of theta and phi, where both are 0: a ray that starts beside where
/// it is said to start, or points beside.
Eigen::Matrix2d angles_by_pose(const Place& ray, const PoseCovariance& covariance) {
  const Eigen::Matrix3d R = ray.T_map_ray.linear();
  Eigen::Matrix<double, 2, 6> J;
  J << ray.mean[2] * R.col(1).transpose(), R.col(2).transpose(),  //
      ray.mean[2] * R.col(2).transpose(), -R.col(1).transpose();
  return J * covariance * J.transpose();
}

/// Eq. 33: three deviations of inverse depth reach from one limit to the other.
Place ray_along(const Eigen::Matrix3d& R_sensor_ray, const Eigen::Matrix2d& angles,
                const UncertainSensorPose& sensor, const UnmeasuredOptions& options) {
  const double nearest = 1.0 / options.min_depth;
  const double furthest = 1.0 / options.max_depth;
  Place place;
  place.form = PlaceForm::ray;
  place.T_map_ray = sensor.T_map_sensor;
  place.T_map_ray.linear() = sensor.T_map_sensor.linear() * R_sensor_ray;
  place.mean = Eigen::Vector3d(0.0, 0.0, 0.5 * (nearest + furthest));
  place.covariance.topLeftCorner<2, 2>() = angles + angles_by_pose(place, sensor.covariance);
  place.covariance(2, 2) = squared((nearest - furthest) / 6.0);
  return place;
}

/// The covariance of theta and phi on the first ray, where both are 0.
template <class Model>
Eigen::Matrix2d angles_of(const Measured<Model>& measured, const Eigen::Matrix3d& R_sensor_ray) {
  const Eigen::Vector3d l = R_sensor_ray.col(0);
  const Eigen::Matrix2d by_angles = measured.model.H(l) * R_sensor_ray *
                                    InverseDepth::direction_by_angles(Eigen::Vector3d::Zero());
  const Eigen::Matrix2d inverse = by_angles.inverse();
  return inverse * measured.variance.asDiagonal() * inverse.transpose();
}

}  // namespace

Eigen::Vector3d inverse_spherical(const Eigen::Vector3d& z) {
  return z[0] * InverseDepth::direction({z[1], z[2], 0.0});
}

Eigen::Matrix3d inverse_spherical_by_z(const Eigen::Vector3d& z) {
  const Eigen::Vector3d x(z[1], z[2], 0.0);
  return (Eigen::Matrix3d() << InverseDepth::direction(x),
          z[0] * InverseDepth::direction_by_angles(x))
      .finished();
}

Eigen::Vector3d inverse_polar(const Eigen::Vector3d& z) {
  return {z[0] * std::cos(z[1]), z[0] * std::sin(z[1]), z[2]};
}

Eigen::Matrix3d inverse_polar_by_z(const Eigen::Vector3d& z) {
  return (Eigen::Matrix3d() << std::cos(z[1]), -z[0] * std::sin(z[1]), 0.0,  //
          std::sin(z[1]), z[0] * std::cos(z[1]), 0.0,                        //
          0.0, 0.0, 1.0)
      .finished();
}

Place inverse_sensor_model(const Measured<SphericalModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& /*options*/) {
  const Eigen::Matrix3d J = inverse_spherical_by_z(measured.z);
  return point_at(inverse_spherical(measured.z), J * measured.variance.asDiagonal() * J.transpose(),
                  sensor);
}

Place inverse_sensor_model(const Measured<PolarModel>& measured, const UncertainSensorPose& sensor,
                           const LandmarkOptions& options) {
  const Eigen::Vector3d z(measured.z[0], measured.z[1], 0.0);
  const Eigen::Vector3d variance(measured.variance[0], measured.variance[1],
                                 squared(options.unmeasured.height_stddev));
  const Eigen::Matrix3d J = inverse_polar_by_z(z);
  return point_at(inverse_polar(z), J * variance.asDiagonal() * J.transpose(), sensor);
}

Place inverse_sensor_model(const Measured<AzimuthModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& options) {
  constexpr double kSteepest = 0.5;  // [rad]
  const double typical_depth =
      std::sqrt(options.unmeasured.min_depth * options.unmeasured.max_depth);
  const double height = std::min(options.unmeasured.height_stddev / typical_depth, kSteepest);
  const Eigen::Vector2d angles(measured.variance[0], squared(height));
  return ray_along(turned_to({std::cos(measured.z[0]), std::sin(measured.z[0]), 0.0}),
                   angles.asDiagonal(), sensor, options.unmeasured);
}

Place inverse_sensor_model(const Measured<DirectionModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& options) {
  const Eigen::Matrix3d R_sensor_ray =
      turned_to(InverseDepth::direction({measured.z[0], measured.z[1], 0.0}));
  return ray_along(R_sensor_ray, angles_of(measured, R_sensor_ray), sensor, options.unmeasured);
}

Place inverse_sensor_model(const Measured<PixelModel>& measured, const UncertainSensorPose& sensor,
                           const LandmarkOptions& options) {
  const PinholeCamera& camera = measured.model.camera;
  const Eigen::Vector3d l((measured.z[0] - camera.cx) / camera.fx,
                          (measured.z[1] - camera.cy) / camera.fy, 1.0);
  const Eigen::Matrix3d R_optical_level = optical_from_level();
  const Eigen::Matrix3d R_sensor_ray = R_optical_level * turned_to(R_optical_level.transpose() * l);
  return ray_along(R_sensor_ray, angles_of(measured, R_sensor_ray), sensor, options.unmeasured);
}

}  // namespace portolan
