// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "portolan/sim/ray_caster.hpp"
#include "portolan/sim/world_options.hpp"

namespace portolan::sim {

/// What really stands around the simulated robot, in the map frame.
class World {
 public:
  using Options = WorldOptions;
  using Marks = std::map<std::int32_t, Eigen::Vector3d>;  // identity -> position [m]

  /// Throws OptionsError with every fault at once; two marks of a kind may not share an identity.
  explicit World(const Options& options);

  /// The first surface on the ray within `max_range` [m]: obstacle, floor or ceiling.
  std::optional<Hit> cast(const Ray& ray, Wave wave, double max_range) const;

  /// True where light goes straight from `from` to within `slack` of `to` [m].
  bool sees(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double slack = 0.02) const;

  /// The distance in the plane to the nearest obstacle between two heights, at most `reach` [m].
  double clearance(const Eigen::Vector2d& p_map, double reach, double bottom, double top) const;

  /// True inside of an obstacle, below the floor and above the ceiling.
  bool is_solid(const Eigen::Vector3d& p_map) const;

  /// True where the cube, its sides along the axes, holds a part of an obstacle, of the floor or of
  /// the ceiling. `half_side` [m].
  bool reaches_into(const Eigen::Vector3d& cube_center, double half_side) const;

  const std::vector<Obstacle>& obstacles() const { return caster_.obstacles(); }
  const Marks& landmarks() const { return landmarks_; }
  const Marks& beacons() const { return beacons_; }

 private:
  RayCaster caster_;
  Marks landmarks_;
  Marks beacons_;
  bool floor_;
  double ceiling_;
};

}  // namespace portolan::sim
