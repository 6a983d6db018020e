// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace portolan {

/// Where a block of 8 x 8 x 8 voxels lies: the keys of its voxels divided by 8.
struct BlockKey {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t z = 0;

  static constexpr int kVoxels = 8;   ///< along a side
  static constexpr int kSide = 8192;  ///< blocks along an axis of the octree

  friend bool operator==(const BlockKey& a, const BlockKey& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};

/// The block that holds a voxel.
inline BlockKey block_of(const octomap::OcTreeKey& key) {
  const auto part = [](octomap::key_type k) { return static_cast<std::uint16_t>(k / 8); };
  return {part(key[0]), part(key[1]), part(key[2])};
}

/// The block at these multiples of 8 voxels, each from 0 to kSide - 1.
inline BlockKey block_key(int x, int y, int z) {
  const auto part = [](int k) { return static_cast<std::uint16_t>(k); };
  return {part(x), part(y), part(z)};
}

/// A yes or no for each voxel of a block: a word for each layer of equal z, in which voxel (x, y)
/// is bit 8 y + x.
using VoxelMask = std::array<std::uint64_t, BlockKey::kVoxels>;

/// The log-odds of 8 x 8 x 8 neighbouring voxels.
struct VoxelBlock {
  /// Of voxel (x, y, z) at 64 z + 8 y + x; 0 where nothing is known.
  alignas(32) std::array<float, 512> log_odds{};
  VoxelMask known{};

  static constexpr std::size_t index(int x, int y, int z) {
    const int place = 64 * z + 8 * y + x;
    return static_cast<std::size_t>(place);
  }
  bool is_known(std::size_t index) const { return ((known[index / 64] >> (index % 64)) & 1) != 0; }
};

/// The known voxels of a block that are at least so likely to be occupied.
VoxelMask occupied(const VoxelBlock& block, float threshold_log_odds);

}  // namespace portolan
