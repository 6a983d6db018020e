// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include <Eigen/Core>

namespace portolan::ros_convert {

/// A geometry_msgs/Point or Vector3.
template <class Vector>
Vector vector(const Eigen::Vector3d& v) {
  Vector message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

/// Row-major, whatever Eigen's own order is.
template <class Matrix, class Array>
void fill(const Matrix& matrix, Array& array) {
  auto out = array.begin();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) *out++ = matrix(row, column);
  }
}

/// Makes the marker the ellipsoid of so many standard deviations of a covariance [m^2].
void fill_ellipsoid(const geometry_msgs::Point& mean, const Eigen::Matrix3d& covariance,
                    double standard_deviations, visualization_msgs::Marker& marker);

}  // namespace portolan::ros_convert
