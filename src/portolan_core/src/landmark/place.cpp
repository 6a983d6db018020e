// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/place.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/landmark/inverse_depth.hpp"

namespace portolan {

bool is_sound(const Place& place) {
  return place.mean.allFinite() && place.covariance.allFinite() &&
         place.covariance.diagonal().minCoeff() >= 0.0;
}

Place as_point(const Place& place, double max_depth) {
  if (place.form == PlaceForm::point) return place;
  Eigen::Vector3d x = place.mean;
  x[2] = std::max(x[2], 1.0 / max_depth);
  const Eigen::Matrix3d J = InverseDepth::point_by_x(place.T_map_ray, x);
  Place point;
  point.mean = InverseDepth::point(place.T_map_ray, x);
  point.covariance = J * place.covariance * J.transpose();
  point.covariance = (0.5 * (point.covariance + point.covariance.transpose())).eval();
  return point;
}

bool has_depth(const Place& place, double max_depth) {
  if (place.form == PlaceForm::point) return true;
  return place.mean[2] - 2.0 * std::sqrt(place.covariance(2, 2)) > 1.0 / max_depth;
}

}  // namespace portolan
