// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/inverse_depth.hpp"

#include <cmath>
#include <limits>

#include "portolan/landmark/sensor_models.hpp"

namespace portolan {

Eigen::Vector3d InverseDepth::direction(const Eigen::Vector3d& x) {
  return {std::cos(x[1]) * std::cos(x[0]), std::cos(x[1]) * std::sin(x[0]), std::sin(x[1])};
}

Eigen::Matrix<double, 3, 2> InverseDepth::direction_by_angles(const Eigen::Vector3d& x) {
  Eigen::Matrix<double, 3, 2> J;
  J << -std::cos(x[1]) * std::sin(x[0]), -std::sin(x[1]) * std::cos(x[0]),  //
      std::cos(x[1]) * std::cos(x[0]), -std::sin(x[1]) * std::sin(x[0]),    //
      0.0, std::cos(x[1]);
  return J;
}

Eigen::Vector3d InverseDepth::point(const Pose& T_map_ray, const Eigen::Vector3d& x) {
  return T_map_ray * Eigen::Vector3d(direction(x) / x[2]);
}

Eigen::Matrix3d InverseDepth::point_by_x(const Pose& T_map_ray, const Eigen::Vector3d& x) {
  Eigen::Matrix3d J;
  J << direction_by_angles(x) / x[2], -direction(x) / (x[2] * x[2]);
  return T_map_ray.linear() * J;
}

Eigen::Vector3d InverseDepth::scaled_in_sensor(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                               const Pose& T_map_sensor) {
  const Eigen::Vector3d baseline = T_map_ray.translation() - T_map_sensor.translation();
  return T_map_sensor.linear().transpose() * (T_map_ray.linear() * direction(x) + x[2] * baseline);
}

Eigen::Matrix3d InverseDepth::scaled_in_sensor_by_x(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                                    const Pose& T_map_sensor) {
  Eigen::Matrix3d J;
  J << T_map_ray.linear() * direction_by_angles(x),
      T_map_ray.translation() - T_map_sensor.translation();
  return T_map_sensor.linear().transpose() * J;
}

Eigen::Vector3d InverseDepth::from_point(const Pose& T_map_ray, const Eigen::Vector3d& p_map) {
  const Eigen::Vector3d l = T_map_ray.linear().transpose() * (p_map - T_map_ray.translation());
  const Eigen::Vector2d angles = DirectionModel::h(l);
  return {angles[0], angles[1], 1.0 / l.norm()};
}

Eigen::Matrix3d InverseDepth::from_point_by_p(const Pose& T_map_ray, const Eigen::Vector3d& p_map) {
  const Eigen::Vector3d l = T_map_ray.linear().transpose() * (p_map - T_map_ray.translation());
  const double distance = l.norm();
  Eigen::Matrix3d J;
  J << DirectionModel::H(l), -l.transpose() / (distance * distance * distance);
  return J * T_map_ray.linear().transpose();
}

double InverseDepth::linearity_index(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                     double rho_variance, const Eigen::Vector3d& p_map) {
  if (!(x[2] > 0.0)) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d p = point(T_map_ray, x);
  const Eigen::Vector3d seen = p - p_map;
  const Eigen::Vector3d first = p - T_map_ray.translation();
  const double cos_parallax = seen.dot(first) / (seen.norm() * first.norm());
  const double depth_stddev = std::sqrt(rho_variance) / (x[2] * x[2]);
  return 4.0 * depth_stddev * std::abs(cos_parallax) / seen.norm();
}

}  // namespace portolan
