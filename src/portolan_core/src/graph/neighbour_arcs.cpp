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

double squared(double x) { return x * x; }

TangentMatrix isotropic(double position, double heading) {
  TangentMatrix covariance = TangentMatrix::Zero();
  covariance.diagonal() << position, position, 0.0, 0.0, 0.0, heading;
  return covariance;
}

/// What odometry says of the way; nearly nothing where it was interrupted or jumped.
Arc odometry_arc(const Keyframe& last, const Keyframe& next, const OdometryNoise& noise,
                 bool is_interrupted) {
  const Pose T_last_next = last.T_odom_base.inverse() * next.T_odom_base;
  const double way = T_last_next.translation().norm();
  const double turn = rotation_angle(T_last_next);
  const double time = to_seconds(next.stamp - last.stamp);
  const bool jumped = is_interrupted || way > noise.max_speed * std::max(time, 0.1) + 0.5;
  constexpr double kStill = 0.01;  // least way that counts, lest anything be certain [m]
  const double counted = std::max(way, kStill);
  constexpr double kCarried = 1.0;  // least way that it may be wrong by then [m]
  const double position =
      squared(noise.position) * counted + (jumped ? squared(std::max(way, kCarried)) : 0.0);
  const double heading =
      squared(noise.heading) * counted + squared(noise.turn) * turn + (jumped ? 1.0 : 0.0);
  Arc arc;
  arc.T_from_to = T_last_next;
  arc.information = information_of(isotropic(position, heading), kSpace);
  arc.kind = ArcKind::odometry;
  return arc;
}

bool fits_better(const Match& a, const Match& b) {
  return a.converged && (!b.converged || a.overlap > b.overlap);
}

/// From where odometry puts it; after an interruption, in which wheels may have begun to count
/// anew, also from where it was. What fits better counts.
Match match_with(const LocalMap& around_last, const Keyframe& next, const Pose& T_last_next,
                 const PoseGraphOptions& options, bool is_interrupted) {
  LocalMapMaker maker(options.surfaces);
  maker.add(next, Pose::Identity());
  const Surface source = std::move(maker).make().surface;
  const SurfaceIndex target(around_last.surface);
  const auto from = [&](const Pose& start) {
    return icp(target, source, start, kSpace, options.icp);
  };
  Match match = from(T_last_next);
  if (!is_interrupted) return match;
  Match stayed = from(Pose::Identity());
  return fits_better(stayed, match) ? stayed : match;
}

Arc arc_of(const Match& match) {
  Arc arc;
  arc.T_from_to = match.T_target_source;
  arc.information = match.information;
  arc.kind = ArcKind::scan;
  return arc;
}

/// Odometry is told of other moments than scans are taken. From step to step that does not add up,
/// so it counts only among scans, which say how far each step went.
void add_lateness(double time, const OdometryNoise& noise, Arc& odometry) {
  const double share = 2.0 * squared(noise.delay / std::max({time, noise.delay, 1e-3}));
  const TangentMatrix late = share * isotropic(odometry.T_from_to.translation().squaredNorm(),
                                               squared(rotation_angle(odometry.T_from_to)));
  odometry.information = information_of(covariance_of(odometry.information, kSpace) + late, kSpace);
}

/// How much two arcs contradict each other: squared Mahalanobis distance over what chance allows.
double contradiction(const Arc& a, const Arc& b) {
  const TangentMatrix covariance =
      covariance_of(a.information, kSpace) + covariance_of(b.information, kSpace);
  const Tangent v = small_motion(a.T_from_to.inverse() * b.T_from_to);
  return mahalanobis_squared(v, covariance, kSpace) / chi_squared_limit(kSpace);
}

ArcReason fault_of(const Match& match, double doubt, const ScanMatchOptions& options) {
  constexpr double kLargestDoubt = 4.0;  // against which a scan that fits well is believed
  const bool sure = match.overlap >= options.sure_overlap && doubt <= kLargestDoubt;
  if (doubt > 1.0 && !sure) return ArcReason::inconsistent;
  return match.overlap < options.min_overlap ? ArcReason::low_overlap : ArcReason::none;
}

}  // namespace

NeighbourArcs neighbour_arcs(const Keyframe& last, const Keyframe& next,
                             const LocalMap& around_last, const PoseGraphOptions& options,
                             bool is_interrupted) {
  NeighbourArcs arcs{odometry_arc(last, next, options.odometry, is_interrupted), std::nullopt};
  if (!options.scans.enabled) return arcs;
  const Match match =
      match_with(around_last, next, arcs.odometry.T_from_to, options, is_interrupted);
  if (!match.converged) return arcs;
  arcs.scan = arc_of(match);
  add_lateness(to_seconds(next.stamp - last.stamp), options.odometry, arcs.odometry);
  const double doubt = contradiction(arcs.odometry, *arcs.scan);
  // One of the two is wrong, and who knows which: odometry shall cover both.
  arcs.odometry.information /= std::max(1.0, doubt);
  arcs.scan->reason = fault_of(match, doubt, options.scans);
  if (arcs.scan->reason != ArcReason::none) arcs.scan->state = ArcState::rejected;
  return arcs;
}

}  // namespace portolan
