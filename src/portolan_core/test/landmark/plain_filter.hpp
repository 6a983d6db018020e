// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "portolan/pose.hpp"

namespace portolan::landmark_test {

/// Eqs. 20-24 to the letter, for one landmark in the plane.
class PlainFilter {
 public:
  void take(double range, double bearing, const Pose& T_map_sensor, const Eigen::Matrix2d& R) {
    const double x = T_map_sensor.translation().x();
    const double y = T_map_sensor.translation().y();
    const double phi = yaw(T_map_sensor);
    if (!started_) {
      const double c = std::cos(phi + bearing);
      const double s = std::sin(phi + bearing);
      const Eigen::Matrix2d J = (Eigen::Matrix2d() << c, -range * s, s, range * c).finished();
      mean = {x + range * c, y + range * s};
      covariance = J * R * J.transpose();
      started_ = true;
      return;
    }
    const double dx = mean.x() - x;
    const double dy = mean.y() - y;
    const double r = std::hypot(dx, dy);
    const Eigen::Vector2d nu(range - r, wrap_angle(bearing - (std::atan2(dy, dx) - phi)));
    const Eigen::Matrix2d H =
        (Eigen::Matrix2d() << dx / r, dy / r, -dy / (r * r), dx / (r * r)).finished();
    const Eigen::Matrix2d K =
        covariance * H.transpose() * (R + H * covariance * H.transpose()).inverse();
    mean += K * nu;
    covariance = (Eigen::Matrix2d::Identity() - K * H) * covariance;
  }

  Eigen::Vector2d mean;
  Eigen::Matrix2d covariance;

 private:
  bool started_ = false;
};

/// Inverse depth as Eqs. 31-35 have it, with all six coordinates (o, theta, phi, rho) and h
/// differentiated numerically: slow and obvious. `h(M')` measures a point in the sensor's frame.
struct SixFilter {
  Eigen::Matrix<double, 6, 1> mean;
  Eigen::Matrix<double, 6, 6> covariance;

  /// Eq. 30 in the axes of REP 103.
  static Eigen::Vector3d point(const Eigen::Matrix<double, 6, 1>& m) {
    const Eigen::Vector3d direction(std::cos(m[4]) * std::cos(m[3]),
                                    std::cos(m[4]) * std::sin(m[3]), std::sin(m[4]));
    return m.head<3>() + direction / m[5];
  }
};

}  // namespace portolan::landmark_test
