// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// The occupied voxels in a band of heights, by x, then y, then z.
std::vector<octomap::OcTreeKey> occupied_voxels(const OctoMapper& map, const HeightBand& band);

/// The voxels that touch another one of the list by a face, an edge or a corner; those that stand
/// alone are taken for noise. Keeps the order, and the map keeps them.
std::vector<octomap::OcTreeKey> without_speckles(const std::vector<octomap::OcTreeKey>& voxels);

}  // namespace portolan
