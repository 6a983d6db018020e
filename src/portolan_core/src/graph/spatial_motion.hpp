// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "portolan/graph/arc.hpp"

namespace portolan {

/// Poses that move in space: x, y, z and a turn about each of them.
struct SpatialMotion {
  static constexpr int kSize = 6;
  static constexpr int kSpace = 3;  ///< coordinates of a position
  static constexpr int kTurns = 3;  ///< axes of the map to turn about
  using Vector = Tangent;
  using Matrix = TangentMatrix;
  using Point = Eigen::Vector3d;
  using Turn = Eigen::Matrix3d;
  using TurnVector = Eigen::Vector3d;

  struct State {
    Point t = Point::Zero();
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    Turn R = Turn::Identity();  // of q
  };

  /// A residual and its derivatives by what moves the poses at both ends, as in `moved`.
  struct Linearized {
    Vector r;
    Matrix H_from;
    Matrix H_to;
  };

  static State turned(const Point& t, const Eigen::Quaterniond& q) {
    return {t, q, q.toRotationMatrix()};
  }
  static State state(const Pose& pose) {
    return turned(pose.translation(), Eigen::Quaterniond(pose.linear()).normalized());
  }
  static Pose pose(const State& state) {
    Pose made = Pose::Identity();
    made.linear() = state.R;
    made.translation() = state.t;
    return made;
  }
  static Matrix information(const TangentMatrix& information) { return information; }

  static const Turn& turn(const State& x) { return x.R; }
  /// The state with the rotation next to the transpose of a matrix.
  static State with_turn(const State& x, const Turn& transposed);
  /// How surely an arc knows about turns, and about positions: weights of one number each.
  static double turn_weight(const Matrix& information) {
    return information.diagonal().tail<3>().mean();
  }
  static double point_weight(const Matrix& information) {
    return information.diagonal().head<3>().mean();
  }

  /// Of the angle of the rotation between two.
  static double cosine_between(const State& a, const State& b) {
    const double half = a.q.dot(b.q);
    return 2.0 * half * half - 1.0;
  }

  /// By which rotation, about axes of the map, an arc's end is turned beyond what was measured: to
  /// first order, twice the sine of half the angle at most.
  static TurnVector turn_left(const State& from, const State& to, const State& measured) {
    return to.R * (2.0 * error(from, to, measured).vec());
  }
  /// The angle of that rotation.
  static double angle_left(const State& from, const State& to, const State& measured) {
    return 2.0 * std::asin(std::min(1.0, error(from, to, measured).vec().norm()));
  }
  /// Turned where it stands, about axes of the map.
  static State turned_on(const State& x, const TurnVector& turn) {
    return turned(x.t, (rotation(turn) * x.q).normalized());
  }

  static State composed(const State& a, const State& b) {
    return turned(a.t + a.R * b.t, (a.q * b.q).normalized());
  }
  static State inverse(const State& a) { return turned(-(a.R.transpose() * a.t), a.q.conjugate()); }
  /// T * exp(v), to first order in v.
  static State moved(const State& x, const Vector& v);
  static Vector residual(const State& from, const State& to, const State& measured);
  static Linearized linearize(const State& from, const State& to, const State& measured);

 private:
  static Eigen::Quaterniond rotation(const Point& turn) {
    const double angle = turn.norm();
    const Point axis = angle > 0.0 ? Point(turn / angle) : Point(Point::UnitX());
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  }
  static Turn cross(const Point& p) {
    Turn m;
    m << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
    return m;
  }
  // Of T_measured^-1 * T_from_to, with w >= 0.
  static Eigen::Quaterniond error(const State& from, const State& to, const State& measured) {
    Eigen::Quaterniond q = measured.q.conjugate() * (from.q.conjugate() * to.q);
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    return q;
  }
};

inline SpatialMotion::State SpatialMotion::with_turn(const State& x, const Turn& transposed) {
  const Eigen::JacobiSVD<Turn> svd(transposed.transpose(),
                                   Eigen::ComputeFullU | Eigen::ComputeFullV);
  Turn u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(2) = -u.col(2);
  return turned(x.t, Eigen::Quaterniond(u * svd.matrixV().transpose()).normalized());
}

inline SpatialMotion::State SpatialMotion::moved(const State& x, const Vector& v) {
  return turned(x.t + x.R * v.head<3>(), (x.q * rotation(v.tail<3>())).normalized());
}

inline SpatialMotion::Vector SpatialMotion::residual(const State& from, const State& to,
                                                     const State& measured) {
  const Point t_from_to = from.R.transpose() * (to.t - from.t);
  Vector r;
  r << measured.R.transpose() * (t_from_to - measured.t), 2.0 * error(from, to, measured).vec();
  return r;
}

inline SpatialMotion::Linearized SpatialMotion::linearize(const State& from, const State& to,
                                                          const State& measured) {
  const Turn back = measured.R.transpose();
  const Point t_from_to = from.R.transpose() * (to.t - from.t);
  const Eigen::Quaterniond q = error(from, to, measured);
  const Turn skew = cross(q.vec());
  const Turn w = q.w() * Turn::Identity();
  Linearized l;
  l.r << back * (t_from_to - measured.t), 2.0 * q.vec();
  l.H_from << -back, back * cross(t_from_to), Turn::Zero(), (skew - w) * back;
  l.H_to << back * from.R.transpose() * to.R, Turn::Zero(), Turn::Zero(), w + skew;
  return l;
}

}  // namespace portolan
