// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "portolan/graph/graph.hpp"
#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/match/local_map.hpp"

namespace portolan {

/// Where a keyframe of this id stands among all of a pose graph, which counts them from 0.
inline std::size_t index_of(PoseId id) { return static_cast<std::size_t>(id); }

/// A square of the floor, and a quarter of all ways to look in it.
using Square = std::tuple<double, double, double>;

/// The square of this side [m] in which a pose lies; a sensor need not see all round.
Square square_of(const Pose& T_map_base, double side);

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

  /// What keyframe i saw, and those before `end` that stood within so far of it [m], in its frame:
  /// one of each metre and way to look, whenever the robot was there.
  LocalMap map_near(std::size_t i, std::size_t end, double distance,
                    const SurfaceOptions& options) const;

  /// The keyframes before `end` that have a scan, one of each square of this side [m].
  std::vector<std::size_t> places(std::size_t end, double side) const;

  /// The keyframe nearest to a pose, among those within so much way of another one [m].
  std::size_t nearest(const Pose& T_map, std::size_t around, double way) const;
  /// The same among those before `end` that have a scan; `end` where none has.
  std::size_t nearest(const Pose& T_map, std::size_t end) const;
};

}  // namespace portolan
