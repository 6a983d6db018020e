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

// What is left of odometry's information where somebody knows better.
constexpr double kNothing = 1e-6;

double squared(double x) { return x * x; }

TangentMatrix isotropic(double position, double heading) {
  TangentMatrix covariance = TangentMatrix::Zero();
  covariance.diagonal() << position, position, 0.0, 0.0, 0.0, heading;
  return covariance;
}

bool has_jumped(const Keyframe& last, const Keyframe& next, const OdometryNoise& noise) {
  const double way = (last.T_odom_base.inverse() * next.T_odom_base).translation().norm();
  return way > noise.max_speed * std::max(to_seconds(next.stamp - last.stamp), 0.1) + 0.5;
}

/// What odometry says of the way; nearly nothing where it was interrupted.
Arc odometry_arc(const Keyframe& last, const Keyframe& next, const OdometryNoise& noise,
                 bool is_interrupted) {
  const Pose T_last_next = last.T_odom_base.inverse() * next.T_odom_base;
  const double way = T_last_next.translation().norm();
  const double turn = rotation_angle(T_last_next);
  constexpr double kStill = 0.01;  // least way that counts, lest anything be certain [m]
  const double counted = std::max(way, kStill);
  constexpr double kCarried = 1.0;  // least way that it may be wrong by then [m]
  const double position =
      squared(noise.position) * counted + (is_interrupted ? squared(std::max(way, kCarried)) : 0.0);
  const double heading =
      squared(noise.heading) * counted + squared(noise.turn) * turn + (is_interrupted ? 1.0 : 0.0);
  Arc arc;
  arc.T_from_to = T_last_next;
  arc.information = information_of(isotropic(position, heading), kSpace);
  arc.kind = ArcKind::odometry;
  return arc;
}

LocalMap map_of(const Keyframe& keyframe, const SurfaceOptions& options) {
  LocalMapMaker maker(options);
  maker.add(keyframe, Pose::Identity());
  return std::move(maker).make();
}

bool fits_better(const Match& a, const Match& b) {
  return a.converged && (!b.converged || a.overlap > b.overlap);
}

/// From where odometry puts it; after an interruption, in which wheels may have begun to count
/// anew, also from where it was. What fits better counts.
Match match_with(const LocalMap& around_last, const LocalMap& here, const Pose& T_last_next,
                 const PoseGraphOptions& options, bool is_interrupted) {
  const SurfaceIndex target(around_last.surface);
  const auto from = [&](const Pose& start) {
    return icp(target, here.surface, start, kSpace, options.icp);
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

/// After an interruption another place may look like the last one: what fits is a guess, as good as
/// one by hand, until loops say the same. Where odometry puts it by then is no better than any
/// other.
void take_for_a_guess(Arc& odometry, Arc& scan) {
  constexpr double kShift = 0.5;  // [m]
  constexpr double kTurn = 0.26;  // [rad]
  const TangentMatrix doubt = isotropic(squared(kShift), squared(kTurn));
  scan.information = information_of(covariance_of(scan.information, kSpace) + doubt, kSpace);
  odometry.information *= kNothing;
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

/// After an interruption as much is asked as of any place where the robot may be.
ArcReason fault_of_guess(const Match& match, const LocalMap& around_last, const LocalMap& here,
                         const PoseGraphOptions& options) {
  if (match.overlap < options.scans.sure_overlap) return ArcReason::low_overlap;
  if (!match.open.empty()) return ArcReason::degenerate;
  const Agreement seen = agreement(around_last, here, match.T_target_source, options.loops.margin);
  return seen.agreed < options.loops.places.min_agreed ? ArcReason::poor_match : ArcReason::none;
}

}  // namespace

NeighbourArcs neighbour_arcs(const Keyframe& last, const Keyframe& next,
                             const LocalMap& around_last, const PoseGraphOptions& options,
                             bool is_interrupted) {
  const bool is_broken = is_interrupted || has_jumped(last, next, options.odometry);
  NeighbourArcs arcs{odometry_arc(last, next, options.odometry, is_broken), std::nullopt};
  if (!options.scans.enabled) return arcs;
  const LocalMap here = map_of(next, options.surfaces);
  const Match match = match_with(around_last, here, arcs.odometry.T_from_to, options, is_broken);
  if (!match.converged) return arcs;
  arcs.scan = arc_of(match);
  if (is_broken) {
    arcs.scan->reason = fault_of_guess(match, around_last, here, options);
    if (arcs.scan->reason == ArcReason::none) take_for_a_guess(arcs.odometry, *arcs.scan);
  } else {
    add_lateness(to_seconds(next.stamp - last.stamp), options.odometry, arcs.odometry);
    const double doubt = contradiction(arcs.odometry, *arcs.scan);
    // One of the two is wrong, and who knows which: odometry shall cover both.
    arcs.odometry.information /= std::max(1.0, doubt);
    arcs.scan->reason = fault_of(match, doubt, options.scans);
  }
  if (arcs.scan->reason != ArcReason::none) arcs.scan->state = ArcState::rejected;
  return arcs;
}

NeighbourArcs neighbour_arcs(const Pose& T_odometry, const UncertainPose& step, bool has_scan) {
  Arc odometry;
  odometry.T_from_to = T_odometry;
  odometry.information = information_of(step.covariance, kSpace);
  odometry.kind = ArcKind::odometry;
  if (!has_scan) return {odometry, std::nullopt};
  Arc scan = odometry;
  scan.T_from_to = step.mean;
  scan.kind = ArcKind::scan;
  odometry.information *= kNothing;
  return {odometry, scan};
}

bool is_between_neighbours(const Arc& arc) {
  return arc.to == arc.from + 1 && (arc.kind == ArcKind::odometry || arc.kind == ArcKind::scan);
}

bool is_gap(const UncertainPose& step) {
  constexpr double kLost = 0.45;  // [m]
  return step.covariance.diagonal().head<2>().maxCoeff() > kLost * kLost;
}

}  // namespace portolan
