// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/occupied_voxels.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_set>

namespace portolan {

namespace {

/// Orders voxels by x, then y, then z.
std::int64_t place_of(const octomap::OcTreeKey& key, int dx = 0, int dy = 0, int dz = 0) {
  return ((std::int64_t{key[0]} + dx) << 36) + ((std::int64_t{key[1]} + dy) << 18) + key[2] + dz;
}

octomap::OcTreeKey voxel(BlockKey key, std::size_t i) {
  const auto part = [](int block, std::size_t place) {
    return static_cast<octomap::key_type>(8 * block + static_cast<int>(place));
  };
  return {part(key.x, i % 8), part(key.y, i / 8 % 8), part(key.z, i / 64)};
}

bool has_neighbour(const std::unordered_set<std::int64_t>& places, const octomap::OcTreeKey& key) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const bool itself = dx == 0 && dy == 0 && dz == 0;
        if (!itself && places.count(place_of(key, dx, dy, dz)) != 0) return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<octomap::OcTreeKey> occupied_voxels(const OctoMapper& map, const HeightBand& band) {
  std::vector<octomap::OcTreeKey> voxels;
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    const VoxelMask mask = occupied(block, map.threshold_log_odds());
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
      const bool is_in = ((mask[i / 64] >> (i % 64)) & 1) != 0 &&
                         band.contains(map.lattice(), 8 * key.z + static_cast<int>(i / 64));
      if (is_in) voxels.push_back(voxel(key, i));
    }
  });
  std::sort(voxels.begin(), voxels.end(),
            [](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
  return voxels;
}

std::vector<octomap::OcTreeKey> without_speckles(const std::vector<octomap::OcTreeKey>& voxels) {
  std::unordered_set<std::int64_t> places;
  for (const octomap::OcTreeKey& key : voxels) places.insert(place_of(key));
  std::vector<octomap::OcTreeKey> kept;
  std::copy_if(voxels.begin(), voxels.end(), std::back_inserter(kept),
               [&](const octomap::OcTreeKey& key) { return has_neighbour(places, key); });
  return kept;
}

}  // namespace portolan
