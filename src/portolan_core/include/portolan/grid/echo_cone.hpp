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
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// The cells that an echo frees and those that it occupies, judged by their centres: R_f, R_o and
/// R_u of the chapter as wedges of at most a quarter turn, free up to one radius and occupied from
/// there to another one.
///
/// Geometry is rounded as a footprint's is, and exact from there on; but a wedge is convex, so that
/// its rows are drawn at once, without an outline.
class EchoCone {
 public:
  /// The options must be good.
  explicit EchoCone(const GridOptions& options);

  /// Places the cone of an echo. Rejected where the sensor tilts too much, and unusable where the
  /// echo is malformed or would be larger than any footprint. The pose must be valid.
  Outcome place(const RangeEcho& echo, const Pose& T_map_sensor);

  /// Puts the cone into a map, whose tiles get this revision. Returns the cells that it covers at
  /// most.
  CellRect apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const;

 private:
  struct Direction {
    double x = 1.0;
    double y = 0.0;
    /// As seen along `axis`, where this one is as seen along the x axis.
    Direction turned(Direction axis) const {
      return {x * axis.x - y * axis.y, x * axis.y + y * axis.x};
    }
  };
  void look_up(double aperture);
  void place_wedges(Direction axis, double reach);
  double extent(double axis, double right, double left) const;

  FineGrid grid_;
  SonarModel model_;
  double side_;         // of a cell [m]
  double least_level_;  // the cosine of the greatest tilt

  // Of cones of this aperture, as seen along their axis.
  double aperture_ = 0.0;
  double half_cosine_ = 1.0;  // -1 where it is all around
  std::size_t wedges_ = 0;
  std::array<Direction, ConeRows::kMaxWedges + 1> sides_;  // of wedges, from right to left

  ConeRows rows_;  // of the echo at hand
};

}  // namespace portolan
