// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "portolan/grid/cell.hpp"
#include "portolan/grid/cone_rows.hpp"
#include "portolan/grid/fine_grid.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/grid/tile_map.hpp"
#include "portolan/observation/range_echo.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// The cells that an echo frees and those that it occupies, judged by their centres: wedges of at
/// most a quarter turn, free up to one radius and occupied from there to another one.
///
/// Geometry is rounded as a footprint's is, and exact from there on; but a wedge is convex, so that
/// its rows are drawn at once, without an outline.
class EchoCone {
 public:
  /// Places the cone of a usable echo. False where it would be larger than any footprint.
  bool place(const RangeEcho& echo, const Pose& T_map_sensor, const GridOptions& options);

  /// Puts the cone into a map, whose tiles get this revision. Returns the cells that it covers at
  /// most.
  CellRect apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const;

 private:
  void look_up_aperture(double aperture);
  void place_wedges(const Eigen::Vector2d& axis, double radius, const FineGrid& grid);
  bool cover(const Eigen::Vector2d& axis, double radius, const FineGrid& grid);

  // Directions of the wedges' sides from right to left, as seen along the axis; of this aperture.
  double aperture_ = 0.0;
  std::size_t wedges_ = 0;
  std::array<Eigen::Vector2d, 5> directions_;

  // Of the echo at hand.
  Footprint::Anchor apex_;
  ConeRows rows_;
  CellRect covered_;  // in the map
};

}  // namespace portolan
