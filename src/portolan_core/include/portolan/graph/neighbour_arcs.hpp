// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/match/local_map.hpp"
#include "portolan/graph/pose_graph_options.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {

/// What holds a keyframe to the one before it.
struct NeighbourArcs {
  Arc odometry;
  /// Rejected where too little fits, or where odometry contradicts and the scan does not fit well
  /// enough to be believed all the same. None where nothing matches.
  std::optional<Arc> scan;
};

/// Motion, information, kind, state and reason of the arcs from one keyframe to the next, whose
/// scan is matched with a map around the last one. Odometry says nearly nothing where it jumped, or
/// where nobody knows what happened in between, and the less the more the scan contradicts it. The
/// scan is no more than a guess then, since another place may look like this one.
NeighbourArcs neighbour_arcs(const Keyframe& last, const Keyframe& next,
                             const LocalMap& around_last, const PoseGraphOptions& options,
                             bool is_interrupted = false);

/// Arcs between neighbours that say together what is known of a step. Odometry keeps its pose,
/// which saved graphs need, and where scans had a say, hardly a weight: all that is known stands in
/// the scan's arc then.
NeighbourArcs neighbour_arcs(const Pose& T_odometry, const UncertainPose& step, bool has_scan);

/// Whether it is one of these arcs.
bool is_between_neighbours(const Arc& arc);

/// Whether nobody knows how the robot came from one keyframe to the next: they are no one place.
bool is_gap(const UncertainPose& step);

}  // namespace portolan
