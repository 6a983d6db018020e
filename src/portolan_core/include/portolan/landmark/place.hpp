// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "portolan/pose.hpp"

namespace portolan {

/// In which coordinates a landmark is estimated.
enum class PlaceForm {
  point,  ///< x, y, z in the map
  ray,    ///< theta, phi, rho about the first ray: see InverseDepth
};

constexpr std::array<const char*, 2> enum_names(PlaceForm) { return {"point", "ray"}; }

/// Where one landmark is: a Gaussian in x y z or, while its depth is uncertain, in inverse depth.
struct Place {
  PlaceForm form = PlaceForm::point;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Pose T_map_ray = Pose::Identity();  ///< of a ray: where it was first seen from, x along the ray
};

/// False where rounding has left nothing of a place that extreme numbers went into.
bool is_sound(const Place& place);

/// The same place as a point: Eq. 30 and its linearisation. A ray whose depth is not below
/// `max_depth` [m], or beyond infinity, gives the point at that depth.
Place as_point(const Place& place, double max_depth);

/// True where a ray's depth, two deviations nearer or further, is still in front and below
/// `max_depth` [m]; where not it says no more than a direction. A point has a depth.
bool has_depth(const Place& place, double max_depth);

}  // namespace portolan
