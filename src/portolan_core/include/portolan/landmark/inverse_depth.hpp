// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/pose.hpp"

namespace portolan {

/// Coordinates of a landmark of which at first only a direction is known: azimuth theta and
/// elevation phi about the ray on which it was first seen [rad], and inverse depth rho [1/m].
///
/// Eqs. 30-31 with the pose of the first sighting known exactly (Sigma_x = 0 in Eq. 32): of the six
/// parameters the three of the origin are constants, kept in `T_map_ray`, whose x axis is the
/// first ray. Angles are thus near 0 and nowhere singular, also for a camera that looks up.
struct InverseDepth {
  /// The unit vector (cos phi cos theta, cos phi sin theta, sin phi) along the ray's axes.
  static Eigen::Vector3d direction(const Eigen::Vector3d& x);

  /// Its derivative by theta and phi.
  static Eigen::Matrix<double, 3, 2> direction_by_angles(const Eigen::Vector3d& x);

  /// The point in the map, Eq. 30; rho must not be 0.
  static Eigen::Vector3d point(const Pose& T_map_ray, const Eigen::Vector3d& x);
  static Eigen::Matrix3d point_by_x(const Pose& T_map_ray, const Eigen::Vector3d& x);

  /// The point in a sensor's frame times rho: finite and smooth through rho = 0, where it is the
  /// direction of a feature at infinity (Eq. 27 without the division of Eq. 30).
  static Eigen::Vector3d scaled_in_sensor(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                          const Pose& T_map_sensor);
  static Eigen::Matrix3d scaled_in_sensor_by_x(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                               const Pose& T_map_sensor);

  /// The other way round: theta, phi, rho of a point in the map that is not the ray's origin.
  static Eigen::Vector3d from_point(const Pose& T_map_ray, const Eigen::Vector3d& p_map);
  static Eigen::Matrix3d from_point_by_p(const Pose& T_map_ray, const Eigen::Vector3d& p_map);

  /// Civera's linearity index of the depth of x with variance `rho_variance`, seen from `p_map`:
  /// 4 sigma_d |cos(parallax)| / distance. Where it is small, x y z are as Gaussian as x is.
  /// Infinite where rho is not above 0.
  static double linearity_index(const Pose& T_map_ray, const Eigen::Vector3d& x,
                                double rho_variance, const Eigen::Vector3d& p_map);
};

}  // namespace portolan
