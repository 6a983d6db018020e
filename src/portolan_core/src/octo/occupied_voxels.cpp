// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/occupied_voxels.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace portolan {

namespace {

/// Orders voxels by x, then y, then z.
std::int64_t place_of(const octomap::OcTreeKey& key) {
  return (std::int64_t{key[0]} << 32) + (std::int64_t{key[1]} << 16) + key[2];
}

octomap::OcTreeKey voxel(BlockKey key, std::size_t i) {
  const auto part = [](int block, std::size_t place) {
    return static_cast<octomap::key_type>(8 * block + static_cast<int>(place));
  };
  return {part(key.x, i % 8), part(key.y, i / 8 % 8), part(key.z, i / 64)};
}

bool contains(const VoxelMask& mask, std::size_t i) {
  return ((mask[i / 64] >> (i % 64)) & 1) != 0;
}

/// The occupied voxels of a block and of those around it, looked up when somebody asks.
class Neighbourhood {
 public:
  Neighbourhood(const OctoMapper& map, BlockKey middle) : map_(map), middle_(middle) {}

  /// Whether a voxel is occupied; coordinates count from the middle block, -1 to 8.
  bool is_occupied(int x, int y, int z) {
    const auto block = [](int i) { return (i + 8) / 8 - 1; };
    const int place = 9 * (block(z) + 1) + 3 * (block(y) + 1) + block(x) + 1;
    auto& mask = masks_.at(static_cast<std::size_t>(place));
    if (!mask) mask = look_up(middle_.x + block(x), middle_.y + block(y), middle_.z + block(z));
    return contains(*mask, VoxelBlock::index((x + 8) % 8, (y + 8) % 8, (z + 8) % 8));
  }

  bool touches_another(int x, int y, int z) {
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const bool itself = dx == 0 && dy == 0 && dz == 0;
          if (!itself && is_occupied(x + dx, y + dy, z + dz)) return true;
        }
      }
    }
    return false;
  }

 private:
  VoxelMask look_up(int x, int y, int z) const {
    const auto is_in = [](int k) { return k >= 0 && k < BlockKey::kSide; };
    if (!is_in(x) || !is_in(y) || !is_in(z)) return {};
    const VoxelBlock* block = map_.blocks().find(block_key(x, y, z));
    return block == nullptr ? VoxelMask{} : occupied(*block, map_.threshold_log_odds());
  }

  const OctoMapper& map_;
  BlockKey middle_;
  std::array<std::optional<VoxelMask>, 27> masks_;
};

void remove_speckles(const OctoMapper& map, BlockKey key, VoxelMask& mask) {
  Neighbourhood around(map, key);
  for (std::size_t i = 0; i < 512; ++i) {
    if (!contains(mask, i)) continue;
    const auto place = static_cast<int>(i);
    if (!around.touches_another(place % 8, place / 8 % 8, place / 64)) {
      mask[i / 64] &= ~(std::uint64_t{1} << (i % 64));
    }
  }
}

}  // namespace

VoxelMask in_band(const OctoMapper& map, BlockKey key, const HeightBand& band) {
  VoxelMask mask{};
  for (std::size_t layer = 0; layer < mask.size(); ++layer) {
    const int key_z = BlockKey::kVoxels * key.z + static_cast<int>(layer);
    if (band.contains(map.lattice(), key_z)) mask[layer] = ~std::uint64_t{0};
  }
  return mask;
}

VoxelMask shown_voxels(const OctoMapper& map, BlockKey key, const VoxelBlock& block,
                       const Shown& shown) {
  VoxelMask mask = in_band(map, key, shown.band);
  const VoxelMask all = occupied(block, map.threshold_log_odds());
  for (std::size_t layer = 0; layer < mask.size(); ++layer) mask[layer] &= all[layer];
  if (shown.hides_speckles) remove_speckles(map, key, mask);
  return mask;
}

std::vector<octomap::OcTreeKey> occupied_voxels(const OctoMapper& map, const Shown& shown) {
  std::vector<octomap::OcTreeKey> voxels;
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    const VoxelMask mask = shown_voxels(map, key, block, shown);
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
      if (contains(mask, i)) voxels.push_back(voxel(key, i));
    }
  });
  std::sort(voxels.begin(), voxels.end(),
            [](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
  return voxels;
}

}  // namespace portolan
