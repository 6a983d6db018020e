// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/observation/pinhole_camera.hpp"

namespace portolan {

// What sensors measure of a point l in their own frame [m]: each model has `h`, its Jacobian `H`
// by l, the `difference` of two measurements, and `scale_free`: whether h(s l) = h(l) for s > 0,
// so that it also holds for directions.

/// Range and azimuth in the sensor's xy plane: the planar scanner of Eq. 18.
struct PolarModel {
  static constexpr int kSize = 2;
  static constexpr bool kScaleFree = false;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  static bool sees(const Eigen::Vector3d& l) { return l.head<2>().squaredNorm() > 0.0; }
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);  ///< Eq. 24
  static Vector difference(const Vector& a, const Vector& b);
};

/// Range, azimuth and elevation: Eq. 18 in three dimensions.
struct SphericalModel {
  static constexpr int kSize = 3;
  static constexpr bool kScaleFree = false;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  static bool sees(const Eigen::Vector3d& l) { return l.head<2>().squaredNorm() > 0.0; }
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Azimuth alone: a planar sensor that measures no range.
struct AzimuthModel {
  static constexpr int kSize = 1;
  static constexpr bool kScaleFree = true;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  static bool sees(const Eigen::Vector3d& l) { return l.head<2>().squaredNorm() > 0.0; }
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Azimuth and elevation: Eq. 26, with axes x forward, y left, z up.
struct DirectionModel {
  static constexpr int kSize = 2;
  static constexpr bool kScaleFree = true;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  static bool sees(const Eigen::Vector3d& l) { return l.head<2>().squaredNorm() > 0.0; }
  static Vector h(const Eigen::Vector3d& l);
  static Jacobian H(const Eigen::Vector3d& l);
  static Vector difference(const Vector& a, const Vector& b);
};

/// Column and row in a rectified image: Eq. 29, with axes x right, y down, z forward.
struct PixelModel {
  static constexpr int kSize = 2;
  static constexpr bool kScaleFree = true;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using Jacobian = Eigen::Matrix<double, kSize, 3>;

  PinholeCamera camera;

  static bool sees(const Eigen::Vector3d& l) { return l.z() > 0.0; }
  Vector h(const Eigen::Vector3d& l) const;
  Jacobian H(const Eigen::Vector3d& l) const;
  static Vector difference(const Vector& a, const Vector& b) { return a - b; }
};

}  // namespace portolan
