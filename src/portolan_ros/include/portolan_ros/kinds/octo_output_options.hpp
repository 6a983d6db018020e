// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "portolan/octo/occupied_voxels.hpp"
#include "portolan/octo/octo_files.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How a 3D map leaves the node.
struct OctoOutputOptions {
  HeightBand occupancy;
  HeightBand projection;
  bool filter_speckles = false;
  double tree_interval = 1.0;
  double max_cells = 1e8;
  double colour_period = 3.0;
  OctoFileOptions files;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("occupancy_min_z", self.occupancy.min_z,
          "voxels wholly below are not shown, neither as cubes nor in projected_map [m]");
    visit("occupancy_max_z", self.occupancy.max_z, "voxels wholly above, likewise [m]");
    visit("projection_min_z", self.projection.min_z,
          "voxels wholly below are not in projected_map [m]");
    visit("projection_max_z", self.projection.max_z, "voxels wholly above, likewise [m]");
    visit("filter_speckles", self.filter_speckles,
          "do not show occupied voxels that touch no other one; the octree keeps them");
    visit("tree_interval", self.tree_interval,
          "least time between whole octrees, and between clouds of centres [s]",
          within(0.05, 3600.0));
    visit("max_cells", self.max_cells, "a larger projected_map is not published [cell]",
          within(1.0, 1e9));
    visit("colour_period", self.colour_period,
          "cubes go once through all colours in such a height [m]", above(0.0));
    OctoFileOptions::describe(self.files, visit);
    visit.require(self.occupancy.min_z < self.occupancy.max_z,
                  "occupancy_min_z must be below occupancy_max_z");
    visit.require(self.projected().min_z < self.projected().max_z,
                  "projection and occupancy heights must have some in common");
  }

  /// The heights that count for the projected map.
  HeightBand projected() const {
    return {std::max(occupancy.min_z, projection.min_z),
            std::min(occupancy.max_z, projection.max_z)};
  }
};

}  // namespace portolan
