// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "portolan/octo/voxel_lattice.hpp"

namespace portolan {

/// A ray made ready to be walked from voxel to voxel: Amanatides and Woo's traversal with the
/// arithmetic of octomap::OcTree::computeRayKeys, so that it crosses the same voxels.
struct RayWalk {
  /// A voxel as one number, so that a step is one addition: x + 2^21 y + 2^42 z.
  using Cell = std::uint64_t;
  static constexpr int kBits = 21;

  static constexpr Cell cell(int x, int y, int z) {
    return static_cast<Cell>(x) + (static_cast<Cell>(y) << kBits) +
           (static_cast<Cell>(z) << (2 * kBits));
  }
  static constexpr std::size_t x(Cell c) { return c & ((Cell{1} << kBits) - 1); }
  static constexpr std::size_t y(Cell c) { return (c >> kBits) & ((Cell{1} << kBits) - 1); }
  static constexpr std::size_t z(Cell c) { return c >> (2 * kBits); }

  /// No key that a walk reaches lies further than this outside of the box around both ends: where
  /// an end lies on a border of voxels, rounding can lead past it.
  static constexpr int kOvershoot = 2;

  std::array<double, 3> t;        ///< length of the ray at the next border across each axis [m]
  std::array<double, 3> t_delta;  ///< length from border to border [m]
  std::array<Cell, 3> step;
  double length;  ///< [m]
  Cell start;     ///< as keys; crossed first
  Cell end;       ///< not crossed
};

/// The walk from one point of the map to another [m]; none where either lies beyond the octree or
/// both in the same voxel.
std::optional<RayWalk> ray_walk(const VoxelLattice& lattice, const octomap::point3d& origin,
                                const octomap::point3d& end);

}  // namespace portolan
