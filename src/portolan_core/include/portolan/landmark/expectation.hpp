// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "portolan/landmark/inverse_depth.hpp"
#include "portolan/landmark/measurement.hpp"
#include "portolan/landmark/place.hpp"
#include "portolan/pose_covariance.hpp"

namespace portolan {

/// A measurement less what was expected of it, linear in the errors of place and sensor pose.
template <class Model>
struct Linearized {
  typename Model::Vector nu;       ///< innovation
  typename Model::Jacobian H;      ///< by the coordinates of the place
  typename Model::Jacobian H_map;  ///< by `seen`
  Eigen::Vector3d seen;            ///< from sensor to landmark, in the map's axes, times `scale`
  double scale = 1.0;
};

/// The derivative by the sensor's pose: moved along the map's axes, and turned about them.
template <class Model>
Eigen::Matrix<double, Model::kSize, 6> by_pose(const Linearized<Model>& linear) {
  Eigen::Matrix<double, Model::kSize, 6> H_pose;
  H_pose << -linear.scale * linear.H_map, linear.H_map * cross_matrix(linear.seen);
  return H_pose;
}

/// Of a landmark whose coordinates are x y z.
template <class Model>
std::optional<Linearized<Model>> linearize_point(const Eigen::Vector3d& p_map,
                                                 const Measured<Model>& measured,
                                                 const Pose& T_map_sensor) {
  const Eigen::Matrix3d R = T_map_sensor.linear();
  const Eigen::Vector3d l = R.transpose() * (p_map - T_map_sensor.translation());
  if (!Model::sees(l)) return std::nullopt;
  const typename Model::Jacobian H = measured.model.H(l) * R.transpose();
  return Linearized<Model>{Model::difference(measured.z, measured.model.h(l)), H, H, R * l, 1.0};
}

/// Of a ray, by the chain rule of Eq. 35, in the form that holds through infinity.
template <class Model>
std::optional<Linearized<Model>> linearize_ray(const Place& ray, const Measured<Model>& measured,
                                               const Pose& T_map_sensor) {
  const Eigen::Vector3d l = InverseDepth::scaled_in_sensor(ray.T_map_ray, ray.mean, T_map_sensor);
  if (!Model::sees(l)) return std::nullopt;
  const typename Model::Jacobian H_l = measured.model.H(l);
  const Eigen::Matrix3d R = T_map_sensor.linear();
  return Linearized<Model>{
      Model::difference(measured.z, measured.model.h(l)),
      H_l * InverseDepth::scaled_in_sensor_by_x(ray.T_map_ray, ray.mean, T_map_sensor),
      H_l * R.transpose(), R * l, ray.mean[2]};
}

/// Of a ray whose range is measured: linear about the point that the sighting shows, `p_map`,
/// since that is known far better than the ray's depth: nu = z - h(x_0) - H (x - x_0), where
/// h(x_0) = z.
template <class Model>
std::optional<Linearized<Model>> linearize_ray_at(const Eigen::Vector3d& p_map, const Place& ray,
                                                  const Measured<Model>& measured,
                                                  const Pose& T_map_sensor) {
  auto linear = linearize_point<Model>(p_map, measured, T_map_sensor);
  if (!linear) return std::nullopt;
  const Eigen::Vector3d x = InverseDepth::from_point(ray.T_map_ray, p_map);
  linear->H *= InverseDepth::point_by_x(ray.T_map_ray, x);
  linear->nu = linear->H * (x - ray.mean);
  return linear;
}

/// Of any place; none where the sensor could not see it like that.
template <class Model>
std::optional<Linearized<Model>> linearize(const Place& place, const Measured<Model>& measured,
                                           const Pose& T_map_sensor) {
  if (place.form == PlaceForm::point) return linearize_point(place.mean, measured, T_map_sensor);
  if constexpr (Model::kScaleFree) {
    return linearize_ray(place, measured, T_map_sensor);
  } else {
    return linearize_ray_at(*shown_point(measured, T_map_sensor), place, measured, T_map_sensor);
  }
}

}  // namespace portolan
