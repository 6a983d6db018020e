// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/pose_covariance.hpp"

#include <Eigen/Eigenvalues>

#include "portolan/observation/limits.hpp"

namespace portolan {

PoseCovariance turned(const PoseCovariance& covariance, const Eigen::Matrix3d& R_b_a) {
  PoseCovariance R = PoseCovariance::Zero();
  R.topLeftCorner<3, 3>() = R_b_a;
  R.bottomRightCorner<3, 3>() = R_b_a;
  return R * covariance * R.transpose();
}

PoseCovariance carried(const PoseCovariance& covariance, const Eigen::Vector3d& arm) {
  PoseCovariance J = PoseCovariance::Identity();
  J.topRightCorner<3, 3>() = -cross_matrix(arm);  // a small rotation w moves it by w x arm
  return J * covariance * J.transpose();
}

bool is_stated(const PoseCovariance& covariance) {
  constexpr double kRounding = 1e-6;
  if (!covariance.allFinite() || covariance.isZero(0.0)) return false;
  if (covariance.diagonal().minCoeff() < 0.0) return false;
  if (!covariance.isApprox(covariance.transpose(), kRounding)) return false;
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> solver(covariance, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= -kRounding * solver.eigenvalues().maxCoeff();
}

PoseCovariance believable(const PoseCovariance& covariance) {
  using Deviations = Eigen::Matrix<double, 6, 1>;
  Deviations widest;
  widest << Eigen::Vector3d::Constant(kWidestDistance), Eigen::Vector3d::Constant(kWidestAngle);
  const Deviations stated = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Deviations shrink = widest.cwiseQuotient(stated.cwiseMax(widest));  // at most 1
  const PoseCovariance bounded = shrink.asDiagonal() * covariance * shrink.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> solver(bounded);
  const PoseCovariance& axes = solver.eigenvectors();
  return axes * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * axes.transpose();
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0)
      .finished();
}

}  // namespace portolan
