// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/loop/consensus.hpp"
#include "portolan/graph/loop/loop_search.hpp"
#include "portolan/graph/pose_graph_options.hpp"

namespace portolan {

/// Compares where a keyframe is with a candidate, and tells what came of it: an arc that is
/// rejected with the reason, or as unconfirmed where nothing speaks against it. It leads from the
/// keyframe that proved to be the nearest.
Arc loop_arc(const PlacedKeyframes& placed, const LoopCandidate& candidate, std::size_t here,
             const PoseGraphOptions& options);

/// What the graph, by the way that it knows between an arc's ends, and the scans there say against
/// it; none where they agree.
ArcReason fault_of(const PlacedKeyframes& placed, const Arc& arc, const TangentMatrix& of_way,
                   const PoseGraphOptions& options);

/// The loops, by index of arc, that confirm an unconfirmed one, itself included: pairwise
/// consistent, enough of them, and spread over enough way. Empty where they do not suffice.
std::vector<std::size_t> confirmation(const PlacedKeyframes& placed, const Chain& chain,
                                      std::size_t arc, const LoopOptions& options);

/// An arc as a way between keyframes.
Link link_of(const Arc& arc);

}  // namespace portolan
