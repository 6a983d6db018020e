// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/grid/grid_score.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan/sim/volume_view.hpp"

namespace portolan::sim {

/// How well a 3D map agrees with the world.
struct VolumeScore {
  CellShare occupied_precision;  ///< occupied in the map: something stands there, within one voxel
  CellShare occupied_recall;     ///< surfaces in view: occupied in the map, within one voxel
  CellShare free_precision;      ///< free in the map: its centre is not within anything solid
  CellShare free_recall;         ///< in view and without any surface: free in the map
};

/// Compares a map with the world, and with the part of it that could be seen.
VolumeScore score(const OctoMapper& map, const World& world, const VolumeView& view);

}  // namespace portolan::sim
