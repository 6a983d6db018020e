// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "portolan/octo/voxel_lattice.hpp"

namespace portolan {

/// A ray made ready to be walked from voxel to voxel: Amanatides and Woo's traversal with the
/// arithmetic of octomap::OcTree::computeRayKeys, so that it crosses the same voxels.
struct RayWalk {
  /// A voxel as one number, so that a step is one addition.
  using Cell = std::uint64_t;
  static constexpr int kBits = 21;

  /// How a cell is made of a key: what a step along each axis adds.
  struct Axes {
    Cell x = 1;
    Cell y = Cell{1} << kBits;
    Cell z = Cell{1} << (2 * kBits);

    constexpr Cell cell(std::int64_t key_x, std::int64_t key_y, std::int64_t key_z) const {
      return static_cast<Cell>(key_x) * x + static_cast<Cell>(key_y) * y +
             static_cast<Cell>(key_z) * z;
    }
    Cell cell(const octomap::OcTreeKey& key) const { return cell(key[0], key[1], key[2]); }
  };

  // From a cell of the axes above, which tell all keys apart that a walk can reach.
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
  Cell start;     ///< crossed first
  Cell end;       ///< not crossed
};

}  // namespace portolan
