// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/neighbour_arcs.hpp"

#include <algorithm>
#include <utility>

#include "portolan/graph/loop/consensus.hpp"
#include "portolan/graph/match/icp.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {

namespace {

constexpr GraphSpace kSpace = GraphSpace::planar;

TangentMatrix isotropic(double position, double heading) {
  TangentMatrix covariance = TangentMatrix::Zero();
  covariance.diagonal() << position, position, 0.0, 0.0, 0.0, heading;
  return covariance;
}

}  // namespace

Arc odometry_arc(const Keyframe& last, const Keyframe& next, const OdometryNoise& noise) {
  const Pose T_last_new = last.T_odom_base.inverse() * next.T_odom_base;
  const double way = T_last_new.translation().norm();
  const double turn = rotation_angle(T_last_new);
  const double time = to_seconds(next.stamp - last.stamp);
  const bool jumped = way > noise.max_speed * std::max(time, 0.1) + 0.5;
  constexpr double kStill = 0.01;  // least way that counts, lest anything be certain [m]
  const double counted = std::max(way, kStill);
  const double position = noise.position * noise.position * counted + (jumped ? way * way : 0.0);
  const double heading = noise.heading * noise.heading * counted + noise.turn * noise.turn * turn +
                         (jumped ? 1.0 : 0.0);
  Arc arc;
  arc.T_from_to = T_last_new;
  arc.information = information_of(isotropic(position, heading), kSpace);
  arc.kind = ArcKind::odometry;
  return arc;
}

std::optional<Arc> scan_arc(const LocalMap& around_last, const Keyframe& next, const Arc& odometry,
                            const PoseGraphOptions& options) {
  LocalMapMaker source(options.surfaces);
  source.add(next, Pose::Identity());
  const Surface surface = std::move(source).make().surface;
  const Match match =
      icp(SurfaceIndex(around_last.surface), surface, odometry.T_from_to, kSpace, options.icp);
  if (!match.converged) return std::nullopt;
  Arc arc = odometry;
  arc.kind = ArcKind::scan;
  arc.T_from_to = match.T_target_source;
  arc.information = match.information;
  const TangentMatrix covariance =
      covariance_of(odometry.information, kSpace) + covariance_of(match.information, kSpace);
  const Tangent v = small_motion(odometry.T_from_to.inverse() * match.T_target_source);
  if (mahalanobis_squared(v, covariance, kSpace) > chi_squared_limit(kSpace)) {
    arc.state = ArcState::rejected;
    arc.reason = ArcReason::inconsistent;
  } else if (match.overlap < options.scans.min_overlap) {
    arc.state = ArcState::rejected;
    arc.reason = ArcReason::low_overlap;
  }
  return arc;
}

}  // namespace portolan
