// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/graph/graph.hpp"
#include "portolan/graph/uncertainty.hpp"

namespace portolan {

/// The way from one keyframe to the next as a saved graph tells it.
struct RestoredStep {
  Pose T_odometry = Pose::Identity();  ///< by odometry alone
  UncertainPose step;                  ///< with what the scans said
};

/// One for each pose, identity for the first. Throws std::invalid_argument where ids do not count
/// from 0, stamps do not increase, or no accepted arc of odometry joins two neighbours.
std::vector<RestoredStep> restored_steps(const Graph& graph);

}  // namespace portolan
