// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/odometry.hpp"

#include <cmath>

namespace portolan::sim {

namespace {

/// A motion in the plane as three parts: turn, go straight, turn [rad, m, rad].
struct Motion {
  double turn1 = 0.0;
  double distance = 0.0;
  double turn2 = 0.0;
};

/// Driving backwards is a negative distance and no turn about.
Motion motion_of(const Pose& T_from_to) {
  const Eigen::Vector2d way = T_from_to.translation().head<2>();
  const double turn = yaw(T_from_to);
  if (way.norm() < 1e-9) return {turn, 0.0, 0.0};
  const double sign = way.x() < 0.0 ? -1.0 : 1.0;
  const double turn1 = std::atan2(sign * way.y(), sign * way.x());
  return {turn1, sign * way.norm(), wrap_angle(turn - turn1)};
}

Pose pose_of(const Motion& motion) {
  return planar_pose(0.0, 0.0, motion.turn1) * planar_pose(motion.distance, 0.0, motion.turn2);
}

/// Variances of the three parts of a motion.
Eigen::Vector3d variances(const Odometry::Options& options, const Motion& motion) {
  const double distance = std::abs(motion.distance);
  const double turn1 = std::abs(motion.turn1);
  const double turn2 = std::abs(motion.turn2);
  return {options.alpha1 * turn1 + 0.5 * options.alpha2 * distance,
          options.alpha3 * distance + options.alpha4 * (turn1 + turn2),
          options.alpha1 * turn2 + 0.5 * options.alpha2 * distance};
}

Motion with_drift(const Odometry::Options& options, const Motion& truth) {
  const double extra = 0.5 * options.turn_per_metre * std::abs(truth.distance);
  return {options.turn_scale * truth.turn1 + extra, options.distance_scale * truth.distance,
          options.turn_scale * truth.turn2 + extra};
}

/// The derivative of the new x, y, heading by the old ones.
Eigen::Matrix3d by_pose(double heading, const Motion& motion) {
  const double direction = heading + motion.turn1;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = -motion.distance * std::sin(direction);
  F(1, 2) = motion.distance * std::cos(direction);
  return F;
}

/// The derivative of the new x, y, heading by turn1, distance, turn2.
Eigen::Matrix3d by_motion(double heading, const Motion& motion) {
  const double s = std::sin(heading + motion.turn1);
  const double c = std::cos(heading + motion.turn1);
  Eigen::Matrix3d G;
  G << -motion.distance * s, c, 0.0,  //
      motion.distance * c, s, 0.0,    //
      1.0, 0.0, 1.0;
  return G;
}

}  // namespace

Odometry::Odometry(const Options& options, std::uint64_t seed, const Pose& T_odom_base)
    : options_(checked(options)), random_(seed, "odometry"), T_odom_base_(T_odom_base) {}

void Odometry::update(const Pose& T_map_base) {
  if (!started_) T_map_base_ = T_map_base;
  started_ = true;
  const Motion truth = motion_of(T_map_base_.inverse() * T_map_base);
  T_map_base_ = T_map_base;

  const Eigen::Vector3d variance = variances(options_, truth);
  const Motion drifted = with_drift(options_, truth);
  Motion read = drifted;
  read.turn1 += random_.normal(0.0, std::sqrt(variance[0]));
  read.distance += random_.normal(0.0, std::sqrt(variance[1]));
  read.turn2 += random_.normal(0.0, std::sqrt(variance[2]));

  const double heading = yaw(T_odom_base_);
  const Eigen::Matrix3d F = by_pose(heading, read);
  const Eigen::Matrix3d G = by_motion(heading, read);
  covariance_ = F * covariance_ * F.transpose() + G * variance.asDiagonal() * G.transpose();
  const Pose T_odom_next = T_odom_base_ * pose_of(read);
  const Eigen::Vector3d p_odom = T_odom_next.translation();
  T_odom_base_ = planar_pose(p_odom.x(), p_odom.y(), yaw(T_odom_next));
}

}  // namespace portolan::sim
