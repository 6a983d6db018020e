// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/pose.hpp"

#include <cmath>

namespace portolan {

Pose planar_pose(double x, double y, double yaw) {
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

double yaw(const Pose& pose) { return wrap_angle(std::atan2(pose(1, 0), pose(0, 0))); }

Pose interpolate(const Pose& a, const Pose& b, double fraction) {
  if (fraction == 0.0 || a.matrix() == b.matrix()) return a;
  if (fraction == 1.0) return b;
  const Eigen::Quaterniond q_a(a.linear());
  const Eigen::Quaterniond q_b(b.linear());
  Pose between = Pose::Identity();
  between.linear() = q_a.slerp(fraction, q_b).toRotationMatrix();
  between.translation() = a.translation() + fraction * (b.translation() - a.translation());
  return between;
}

bool is_valid(const Pose& pose) {
  constexpr double kFurthest = 1e8;  // [m]
  const Eigen::Matrix3d R = pose.linear();
  const Eigen::Matrix3d error = R.transpose() * R - Eigen::Matrix3d::Identity();
  // All of these are false of what is not a number.
  return (pose.translation().array().abs() < kFurthest).all() &&
         (error.array().abs() <= 1e-6).all() && R.determinant() > 0.0;
}

double rotation_angle(const Pose& pose) { return Eigen::AngleAxisd(pose.linear()).angle(); }

double wrap_angle(double angle) {
  if (angle > -M_PI && angle <= M_PI) return angle;
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped > -M_PI ? wrapped : wrapped + 2.0 * M_PI;
}

}  // namespace portolan
