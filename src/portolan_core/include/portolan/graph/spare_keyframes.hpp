// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/pose_graph_options.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {

/// Keyframes that a full graph can do without, so many at most, by increasing index; `steps` lead
/// to each keyframe from the one before. First go those whose place was seen most often since, for
/// the length of the step that they leave, and without which the correction moves least: so the
/// past gets the sparser the longer ago it is, but not where the robot has never come back, nor
/// where odometry went astray.
///
/// Never the first keyframe, one over which a step would be vague, what matching and loops at the
/// newest keyframe look back at, what given, disabled or new arcs end at, or two neighbours.
std::vector<std::size_t> spare_keyframes(const PlacedKeyframes& placed,
                                         const std::vector<UncertainPose>& steps, std::size_t most,
                                         const PoseGraphOptions& options);

}  // namespace portolan
