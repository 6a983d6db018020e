// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>

#include "portolan/octo/occupied_voxels.hpp"

namespace portolan {

/// The occupied voxels of a map as cubes for rviz: a marker for each brick of 64 x 64 x 64 voxels,
/// so that only bricks that changed are sent again.
class CellMarkers {
 public:
  /// Colours go once round the wheel in `colour_period` [m] of height.
  CellMarkers(const Shown& shown, double colour_period)
      : shown_(shown), colour_period_(colour_period) {}

  /// The markers of all bricks that changed since the last call, all of them after `forget`.
  /// `generation` tells one map from another that took its place; then the old cubes go first.
  /// Headers: left to the caller.
  visualization_msgs::MarkerArray changes(const OctoMapper& map, std::size_t generation);

  /// Somebody listens who has seen nothing yet.
  void forget() { seen_.reset(); }

 private:
  using BrickId = std::int32_t;

  std::set<BrickId> changed_bricks(const OctoMapper& map) const;
  visualization_msgs::Marker brick(const OctoMapper& map, BrickId id) const;

  Shown shown_;
  double colour_period_;
  std::set<BrickId> sent_;  // those that hold cubes where they were received
  std::size_t generation_ = 0;
  std::optional<OctoMapper::Revision> seen_;
};

}  // namespace portolan
