// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "portolan/octo/octo_mapper.hpp"

namespace portolan {

/// Heights that count for something [m]; names of octomap_server.
struct HeightBand {
  double min_z = -1e6;
  double max_z = 1e6;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_z", self.min_z, "voxels wholly below this do not count [m]");
    visit("max_z", self.max_z, "voxels wholly above this do not count [m]");
    visit.require(self.min_z < self.max_z, "min_z must be below max_z");
  }

  /// Whether any part of a voxel lies in the band.
  bool contains(const VoxelLattice& lattice, int key_z) const {
    const double half = 0.5 * lattice.resolution();
    return lattice.centre(key_z) + half > min_z && lattice.centre(key_z) - half < max_z;
  }
};

/// What of a map is shown: voxels in a band of heights, and on request no speckles, which are
/// occupied voxels that touch no other one by a face, an edge or a corner. The map keeps them all.
struct Shown {
  HeightBand band;
  bool hides_speckles = false;
};

/// The voxels of a block that lie in the band.
VoxelMask in_band(const OctoMapper& map, BlockKey key, const HeightBand& band);

/// The occupied voxels of a block that are shown.
VoxelMask shown_voxels(const OctoMapper& map, BlockKey key, const VoxelBlock& block,
                       const Shown& shown);

/// Calls visit(key) for each block of which other voxels may be shown after this one changed: its
/// neighbours too where speckles are hidden.
template <class Visit>
void for_each_affected(BlockKey key, const Shown& shown, Visit visit) {
  const int reach = shown.hides_speckles ? 1 : 0;
  const auto low = [reach](int k) { return std::max(k - reach, 0); };
  const auto high = [reach](int k) { return std::min(k + reach, BlockKey::kSide - 1); };
  for (int x = low(key.x); x <= high(key.x); ++x) {
    for (int y = low(key.y); y <= high(key.y); ++y) {
      for (int z = low(key.z); z <= high(key.z); ++z) visit(block_key(x, y, z));
    }
  }
}

/// All occupied voxels that are shown, by x, then y, then z.
std::vector<octomap::OcTreeKey> occupied_voxels(const OctoMapper& map, const Shown& shown);

}  // namespace portolan
