// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/graph.hpp"
#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/match/local_map.hpp"

namespace portolan {

/// Keyframes at the poses that a graph gives them; what is asked of both together.
/// Keyframe i is the pose of id i.
struct PlacedKeyframes {
  const std::vector<Keyframe>& keyframes;
  const Graph& graph;

  const Pose& T_map_base(std::size_t i) const { return graph.poses()[i].T_map_pose; }
  Pose between(std::size_t i, std::size_t j) const {
    return T_map_base(i).inverse() * T_map_base(j);
  }

  /// What keyframe i and those within so much way before and after it [m] saw, in its frame.
  LocalMap map_around(std::size_t i, double way_before, double way_after,
                      const SurfaceOptions& options) const;

  /// The keyframe nearest to a pose, among those within so much way of another one [m].
  std::size_t nearest(const Pose& T_map, std::size_t around, double way) const;
};

}  // namespace portolan
