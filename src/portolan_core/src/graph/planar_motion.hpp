// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "portolan/graph/arc.hpp"

namespace portolan {

/// Poses that move in the plane: x, y and heading.
struct PlanarMotion {
  static constexpr int kSize = 3;
  static constexpr int kSpace = 2;  ///< coordinates of a position
  static constexpr int kTurns = 1;  ///< axes of the map to turn about
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;
  using Point = Eigen::Vector2d;
  using Turn = Eigen::Matrix2d;
  using TurnVector = Eigen::Matrix<double, kTurns, 1>;

  struct State {
    Point t = Point::Zero();
    double heading = 0.0;
    double c = 1.0;  // of the heading
    double s = 0.0;
  };

  /// A residual and its derivatives by what moves the poses at both ends, as in `moved`.
  struct Linearized {
    Vector r;
    Matrix H_from;
    Matrix H_to;
  };

  static State state(const Pose& pose);
  static Pose pose(const State& state) {
    Pose made = Pose::Identity();
    made.matrix().topLeftCorner<2, 2>() = turn(state);
    made.translation().head<2>() = state.t;
    return made;
  }
  static Matrix information(const TangentMatrix& information);
  static State turned(const Point& t, double heading) {
    return {t, heading, std::cos(heading), std::sin(heading)};
  }

  static Turn turn(const State& x) { return (Turn() << x.c, -x.s, x.s, x.c).finished(); }
  /// How surely an arc knows about turns, and about positions: weights of one number each.
  static double turn_weight(const Matrix& information) { return information(2, 2); }
  static double point_weight(const Matrix& information) {
    return 0.5 * (information(0, 0) + information(1, 1));
  }

  /// Of the angle between two headings.
  static double cosine_between(const State& a, const State& b) { return a.c * b.c + a.s * b.s; }

  /// By which rotation, about axes of the map, an arc's end is turned beyond what was measured.
  static TurnVector turn_left(const State& from, const State& to, const State& measured) {
    return TurnVector::Constant(wrap_angle(to.heading - from.heading - measured.heading));
  }
  /// The angle of that rotation.
  static double angle_left(const State& from, const State& to, const State& measured) {
    return std::abs(turn_left(from, to, measured)[0]);
  }
  /// Turned where it stands, about axes of the map.
  static State turned_on(const State& x, const TurnVector& turn) {
    return turned(x.t, wrap_angle(x.heading + turn[0]));
  }

  static State composed(const State& a, const State& b) {
    return turned(a.t + turn(a) * b.t, a.heading + b.heading);
  }
  static State inverse(const State& a) { return turned(-(turn(a).transpose() * a.t), -a.heading); }
  /// T * exp(v), to first order in v.
  static State moved(const State& x, const Vector& v) {
    return turned(x.t + turn(x) * v.head<2>(), wrap_angle(x.heading + v[2]));
  }
  static Vector residual(const State& from, const State& to, const State& measured);
  static Linearized linearize(const State& from, const State& to, const State& measured);
};

inline PlanarMotion::State PlanarMotion::state(const Pose& pose) {
  const double c = pose(0, 0);
  const double s = pose(1, 0);
  const double length = std::sqrt(c * c + s * s);
  if (length == 0.0) return turned(pose.translation().head<2>(), 0.0);
  return {pose.translation().head<2>(), yaw(pose), c / length, s / length};
}

inline PlanarMotion::Matrix PlanarMotion::information(const TangentMatrix& information) {
  const TangentMatrix& m = information;
  Matrix planar;
  planar << m.topLeftCorner<2, 2>(), m.block<2, 1>(0, 5), m.block<1, 2>(5, 0), m(5, 5);
  return planar;
}

inline PlanarMotion::Vector PlanarMotion::residual(const State& from, const State& to,
                                                   const State& measured) {
  const Point t_from_to = turn(from).transpose() * (to.t - from.t);
  Vector r;
  r << turn(measured).transpose() * (t_from_to - measured.t),
      wrap_angle(to.heading - from.heading - measured.heading);
  return r;
}

inline PlanarMotion::Linearized PlanarMotion::linearize(const State& from, const State& to,
                                                        const State& measured) {
  const Turn back = turn(measured).transpose();
  const Point t_from_to = turn(from).transpose() * (to.t - from.t);
  Linearized l;
  l.r << back * (t_from_to - measured.t), wrap_angle(to.heading - from.heading - measured.heading);
  l.H_from << -back, back * Point(t_from_to.y(), -t_from_to.x()), 0.0, 0.0, -1.0;
  l.H_to << back * turn(from).transpose() * turn(to), Point::Zero(), 0.0, 0.0, 1.0;
  return l;
}

}  // namespace portolan
