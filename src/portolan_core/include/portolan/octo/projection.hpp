// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "portolan/octo/occupied_voxels.hpp"

namespace portolan {

/// A 3D map seen from above: a cell is occupied where something stands in the column over it, free
/// where the map knows the column and nothing stands in it. It follows the map at a cost that goes
/// with what changed.
class Projection {
 public:
  /// Cells of the side of a voxel, row by row from the lowest y, each row from the lowest x; as in
  /// nav_msgs/OccupancyGrid.
  struct Grid {
    double resolution = 0.0;  ///< [m]
    double x = 0.0;           ///< of the lower left corner of the lower left cell [m]
    double y = 0.0;
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::int8_t> cells;  ///< -1 unknown, 0 free, 100 occupied
  };

  /// Throws OptionsError where the band is none.
  explicit Projection(const Shown& shown) : shown_{checked(shown.band), shown.hides_speckles} {}

  /// Takes over what changed. `generation` tells one map from another that took its place.
  void follow(const OctoMapper& map, std::size_t generation);

  /// The rectangle of all columns of which something is known, rounded up to 8 x 8 cells.
  Grid grid() const;

  /// How many cells that rectangle has: far from each other, few columns can span very many.
  double area() const;

 private:
  /// 8 x 8 columns, as in a layer of a VoxelMask.
  struct Columns {
    std::uint64_t known = 0;
    std::uint64_t occupied = 0;
  };
  using Place = std::pair<int, int>;  // block x, y
  struct Bounds {
    int low_x = 0;
    int low_y = BlockKey::kSide;
    int high_x = -1;
    int high_y = -1;
  };

  Bounds bounds() const;
  Columns look_down(const OctoMapper& map, const Place& place) const;

  Shown shown_;
  std::optional<VoxelLattice> lattice_;
  std::map<Place, Columns> columns_;
  int lowest_ = BlockKey::kSide;  // block z of the map
  int highest_ = -1;
  std::size_t generation_ = 0;
  std::optional<OctoMapper::Revision> seen_;
};

}  // namespace portolan
