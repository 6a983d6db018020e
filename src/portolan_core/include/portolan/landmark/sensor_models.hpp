// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/observation/limits.hpp"
#include "portolan/observation/pinhole_camera.hpp"

namespace portolan {

/// What every sensor's model says of a point l in the sensor's frame [m]; beside it each has the
/// measurement `h`, its Jacobian `H` by l, and the `difference` of two measurements.
template <int size, bool scale_free>
struct PointModel {
  static constexpr int kSize = size;
  /// Whether h(s l) = h(l) for s > 0, so that it also holds for directions.
  static constexpr bool kScaleFree = scale_free;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  /// Not where its azimuth is undefined, or as good as that.
  static bool sees(const Eigen::Vector3d& l) {
    return l.head<2>().squaredNorm() >= kSharpestDistance * kSharpestDistance;
  }
};

/// Range and azimuth in the sensor's xy plane: the planar scanner of Eq. 18.
struct PolarModel : PointModel<2, false> {
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);  ///< Eq. 24
  static Vector difference(const Vector& a, const Vector& b);
};

/// Range, azimuth and elevation: Eq. 18 in three dimensions.
struct SphericalModel : PointModel<3, false> {
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Azimuth alone: a planar sensor that measures no range.
struct AzimuthModel : PointModel<1, true> {
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Azimuth and elevation: Eq. 26, with axes x forward, y left, z up.
struct DirectionModel : PointModel<2, true> {
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Column and row in a rectified image: Eq. 29, with axes x right, y down, z forward.
struct PixelModel : PointModel<2, true> {
  PinholeCamera camera;

  static bool sees(const Eigen::Vector3d& l) { return l.z() >= kSharpestDistance; }
  Vector h(const Eigen::Vector3d& l) const;
  Jacobian H(const Eigen::Vector3d& l) const;
  static Vector difference(const Vector& a, const Vector& b) { return a - b; }
};

}  // namespace portolan
