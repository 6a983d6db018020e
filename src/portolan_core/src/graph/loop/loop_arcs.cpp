// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/loop_arcs.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr GraphSpace kSpace = GraphSpace::planar;

// Loops near enough to say something of another one.
std::vector<std::size_t> loops_near(const PlacedKeyframes& placed, const Arc& own, double reach) {
  const auto near = [&](PoseId a, PoseId b) {
    const auto& keyframes = placed.keyframes;
    return std::abs(keyframes[index_of(a)].travelled - keyframes[index_of(b)].travelled) <= reach;
  };
  std::vector<std::size_t> found;
  const std::vector<Arc>& arcs = placed.graph.arcs();
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const bool stands =
        arcs[i].kind == ArcKind::loop &&
        (arcs[i].state == ArcState::accepted ||
         (arcs[i].state == ArcState::rejected && arcs[i].reason == ArcReason::unconfirmed));
    if (stands && near(arcs[i].from, own.from) && near(arcs[i].to, own.to)) found.push_back(i);
  }
  return found;
}

}  // namespace

Link link_of(const Arc& arc) {
  return {index_of(arc.from),
          index_of(arc.to),
          {arc.T_from_to, covariance_of(arc.information, kSpace)}};
}

// First in a map that is wide enough for what is uncertain, then around the keyframe found there.
Arc loop_arc(const PlacedKeyframes& placed, const LoopCandidate& candidate, std::size_t here,
             const PoseGraphOptions& options) {
  const double way = options.loops.map_way;
  const double reach = way + window_of(candidate.T_candidate_now, options.loops).reach;
  const LocalMap source = placed.map_around(here, 2.0 * way, 0.0, options.surfaces);
  const LocalMap wide = placed.map_around(candidate.keyframe, reach, reach, options.surfaces);
  const Sighting sighting = locate(wide, source, candidate.T_candidate_now, options.loops);
  Arc arc;
  arc.from = static_cast<PoseId>(candidate.keyframe);
  arc.to = static_cast<PoseId>(here);
  arc.T_from_to = sighting.T_target_source;
  arc.information.setZero();
  arc.kind = ArcKind::loop;
  arc.state = ArcState::rejected;
  arc.reason = sighting.reason;
  if (sighting.reason != ArcReason::none) return arc;
  const Pose T_map_here = placed.T_map_base(candidate.keyframe) * sighting.T_target_source;
  const std::size_t place = placed.nearest(T_map_here, candidate.keyframe, reach);
  const Pose T_place_candidate = placed.between(place, candidate.keyframe);
  const UncertainPose expected{T_place_candidate * candidate.T_candidate_now.mean,
                               candidate.T_candidate_now.covariance};
  const LocalMap target = placed.map_around(place, way, way, options.surfaces);
  const LoopFinding finding = examine(target, source, T_place_candidate * sighting.T_target_source,
                                      expected, options.loops, options.icp);
  arc.from = static_cast<PoseId>(place);
  arc.T_from_to = finding.match.T_target_source;
  arc.information = finding.match.information;
  arc.reason = finding.reason == ArcReason::none ? ArcReason::unconfirmed : finding.reason;
  return arc;
}

ArcReason fault_of(const PlacedKeyframes& placed, const Arc& arc, const TangentMatrix& of_way,
                   const PoseGraphOptions& options) {
  const std::size_t from = index_of(arc.from);
  const std::size_t to = index_of(arc.to);
  const UncertainPose told{arc.T_from_to, covariance_of(arc.information, kSpace)};
  const Tangent v = small_motion(placed.between(from, to).inverse() * told.mean);
  if (mahalanobis_squared(v, of_way + told.covariance, kSpace) > chi_squared_limit(kSpace)) {
    return ArcReason::inconsistent;
  }
  const double way = options.loops.map_way;
  const LocalMap target = placed.map_around(from, way, way, options.surfaces);
  const LocalMap source = placed.map_around(to, way, way, options.surfaces);
  return examine(target, source, told.mean, told, options.loops, options.icp).reason;
}

std::vector<std::size_t> confirmation(const PlacedKeyframes& placed, const Chain& chain,
                                      std::size_t arc, const LoopOptions& options) {
  const std::vector<Arc>& arcs = placed.graph.arcs();
  const std::vector<std::size_t> near = loops_near(placed, arcs[arc], options.confirmation_reach);
  std::vector<Link> loops;
  loops.reserve(near.size());
  for (const std::size_t i : near) loops.push_back(link_of(arcs[i]));
  const auto self =
      static_cast<std::size_t>(std::find(near.begin(), near.end(), arc) - near.begin());
  if (self == near.size()) return {};
  std::vector<std::size_t> clique;
  double first = placed.keyframes[index_of(arcs[arc].to)].travelled;
  double last = first;
  for (const std::size_t i : consensus(loops, self, chain)) {
    clique.push_back(near[i]);
    const double way = placed.keyframes[loops[i].to].travelled;
    first = std::min(first, way);
    last = std::max(last, way);
  }
  const bool many = clique.size() > static_cast<std::size_t>(options.min_confirmations);
  const bool wide = last - first >= options.confirmation_way;
  return many && wide ? clique : std::vector<std::size_t>{};
}

}  // namespace portolan
