// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace portolan {

namespace {

// Numbers of the tangent's elements that count.
const std::vector<int>& elements(GraphSpace space) {
  static const std::vector<int> kPlanar = {0, 1, 5};
  static const std::vector<int> kSpatial = {0, 1, 2, 3, 4, 5};
  return space == GraphSpace::planar ? kPlanar : kSpatial;
}

Eigen::MatrixXd part(const TangentMatrix& whole, GraphSpace space) {
  const std::vector<int>& e = elements(space);
  Eigen::MatrixXd small(e.size(), e.size());
  for (Eigen::Index i = 0; i < small.rows(); ++i) {
    for (Eigen::Index j = 0; j < small.cols(); ++j) {
      small(i, j) = whole(e[static_cast<std::size_t>(i)], e[static_cast<std::size_t>(j)]);
    }
  }
  return small;
}

TangentMatrix whole(const Eigen::MatrixXd& part, GraphSpace space) {
  const std::vector<int>& e = elements(space);
  TangentMatrix large = TangentMatrix::Zero();
  for (Eigen::Index i = 0; i < part.rows(); ++i) {
    for (Eigen::Index j = 0; j < part.cols(); ++j) {
      large(e[static_cast<std::size_t>(i)], e[static_cast<std::size_t>(j)]) = part(i, j);
    }
  }
  return large;
}

// The inverse with eigenvalues not below `least`.
TangentMatrix bounded_inverse(const TangentMatrix& matrix, GraphSpace space, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(part(matrix, space));
  const Eigen::VectorXd inverses = solver.eigenvalues().cwiseMax(least).cwiseInverse();
  const Eigen::MatrixXd& V = solver.eigenvectors();
  return whole(V * inverses.asDiagonal() * V.transpose(), space);
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace

TangentMatrix adjoint(const Pose& T) {
  const Eigen::Matrix3d R = T.linear();
  TangentMatrix A = TangentMatrix::Zero();
  A.topLeftCorner<3, 3>() = R;
  A.bottomRightCorner<3, 3>() = R;
  A.topRightCorner<3, 3>() = cross_matrix(T.translation()) * R;
  return A;
}

UncertainPose operator*(const UncertainPose& T_a_b, const UncertainPose& T_b_c) {
  const TangentMatrix A = adjoint(T_b_c.mean.inverse());
  return {T_a_b.mean * T_b_c.mean, A * T_a_b.covariance * A.transpose() + T_b_c.covariance};
}

UncertainPose inverse(const UncertainPose& T_a_b) {
  const TangentMatrix A = adjoint(T_a_b.mean);
  return {T_a_b.mean.inverse(), A * T_a_b.covariance * A.transpose()};
}

Tangent small_motion(const Pose& T) {
  const Eigen::Quaterniond q(T.linear());
  Tangent v;
  v << T.translation(), (q.w() < 0.0 ? -2.0 : 2.0) * q.vec();
  return v;
}

Pose motion(const Tangent& v) {
  Pose T = Pose::Identity();
  T.translation() = v.head<3>();
  const Eigen::Vector3d half = 0.5 * v.tail<3>();
  const double w = std::sqrt(std::max(0.0, 1.0 - half.squaredNorm()));
  T.linear() = Eigen::Quaterniond(w, half.x(), half.y(), half.z()).normalized().toRotationMatrix();
  return T;
}

TangentMatrix covariance_of(const TangentMatrix& information, GraphSpace space) {
  return bounded_inverse(information, space, 1e-6);
}

TangentMatrix information_of(const TangentMatrix& covariance, GraphSpace space) {
  return bounded_inverse(covariance, space, 1e-12);
}

UncertainPose fused(const Arc& a, const Arc& b, GraphSpace space) {
  const TangentMatrix covariance = covariance_of(a.information + b.information, space);
  const Tangent difference = small_motion(a.T_from_to.inverse() * b.T_from_to);
  return {a.T_from_to * motion(covariance * (b.information * difference)), covariance};
}

double mahalanobis_squared(const Tangent& v, const TangentMatrix& covariance, GraphSpace space) {
  return v.dot(information_of(covariance, space) * v);
}

}  // namespace portolan
