// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/match/local_map.hpp"
#include "portolan/graph/pose_graph_options.hpp"

namespace portolan {

/// What odometry says of the way from one keyframe to the next; nearly nothing where it jumped.
/// Only motion and information are filled in.
Arc odometry_arc(const Keyframe& last, const Keyframe& next, const OdometryNoise& noise);

/// What the next scan says, matched with a map around the last keyframe: an arc like that of
/// odometry, rejected where too little fits or odometry contradicts. None where nothing matches.
std::optional<Arc> scan_arc(const LocalMap& around_last, const Keyframe& next, const Arc& odometry,
                            const PoseGraphOptions& options);

}  // namespace portolan
