// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/loop/loop_options.hpp"
#include "portolan/graph/loop/reckoning.hpp"
#include "portolan/graph/match/icp.hpp"
#include "portolan/graph/match/local_map.hpp"

namespace portolan {

/// An earlier keyframe that may show the place where the robot is now.
struct LoopCandidate {
  std::size_t keyframe = 0;
  UncertainPose T_candidate_now;
};

/// The earlier visits that may lie within reach, given how uncertain it is where they lie: of each
/// visit the keyframe nearest to here, the likeliest visits first; of those that are known this
/// well [m], see `LoopOptions`, none. `T_now` are all keyframes as seen from the last one.
std::vector<LoopCandidate> loop_candidates(const std::vector<Keyframe>& keyframes,
                                           const std::vector<std::optional<UncertainPose>>& T_now,
                                           double min_doubt, const LoopOptions& options);

/// Where a wide search puts the source, or why it does not.
struct Sighting {
  Pose T_target_source = Pose::Identity();
  ArcReason reason = ArcReason::none;
};

/// The area that has to be searched for a place that should lie there.
SearchWindow window_of(const UncertainPose& T_target_source, const LoopOptions& options);

/// Finds the source somewhere in the target, where closest points would not find it from the
/// expected place; that place itself where they would.
Sighting locate(const LocalMap& target, const LocalMap& source, const UncertainPose& expected,
                const LoopOptions& options);

/// What came of comparing two places.
struct LoopFinding {
  Match match;
  Agreement agreement;
  ArcReason reason = ArcReason::none;  ///< why it is no loop; none where it is one
};

/// Whether both maps show one place, near the guess and where it can be expected: iterated closest
/// points, and what each saw of the other.
LoopFinding examine(const LocalMap& target, const LocalMap& source, const Pose& T_target_source,
                    const UncertainPose& expected, const LoopOptions& options,
                    const IcpOptions& icp_options);

}  // namespace portolan
