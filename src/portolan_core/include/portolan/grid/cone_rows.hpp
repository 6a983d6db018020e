// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "portolan/grid/cell.hpp"
#include "portolan/grid/fine_walk.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/tile_map.hpp"

namespace portolan {

/// A cone as rows of cells see it: each row of a wedge is a span between lines and within discs.
/// Lengths are in cells, from the apex.
struct ConeRows {
  /// The x of a line through the apex, at the middle of a row.
  struct Line {
    double slope = 0.0;
    double offset = 0.0;
  };
  /// Lines bound a row of a wedge from the left and from the right; where a wedge has both of its
  /// sides on the left, none bounds it on the right.
  struct Wedge {
    std::array<Line, 2> from;
    std::array<Line, 2> to;
  };
  static constexpr std::size_t kMaxWedges = 4;
  static constexpr double kFar = 1e5;  ///< beyond every footprint

  /// Adds the wedge of at most a quarter turn that reaches from `right` counterclockwise to `left`,
  /// where its sides pass these points.
  void add(FinePoint right, FinePoint left) {
    Wedge& wedge = wedges[count++];
    wedge.from = {Line{0.0, -kFar}, Line{0.0, -kFar}};
    wedge.to = {Line{0.0, kFar}, Line{0.0, kFar}};
    (right.y > 0 ? wedge.to : wedge.from)[0] = line(right);
    (left.y > 0 ? wedge.from : wedge.to)[1] = line(left);
  }

  /// What is free lies nearer to the apex than `free`, what is occupied from there to `reach`, in
  /// 1/1024 of a cell.
  void set_radii(std::int64_t free, std::int64_t reach) {
    free_square = square_below(free);
    reach_square = square_below(reach);
  }

  /// Puts the cone into a map, whose tiles get this revision. False where it has no cell. With the
  /// widest vectors that the processor has; the result does not depend on it.
  bool apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const;

  /// The same without the vectors of particular processors.
  bool apply_portably(TileMap& map, const CellUpdate& update, std::uint64_t revision) const;

  Footprint::Anchor apex;  // in the map
  CellRect covered;        // in the map: all cells of the cone lie there
  std::array<Wedge, kMaxWedges> wedges;
  std::size_t count = 0;  // of wedges
  double free_square = 0.0;
  double reach_square = 0.0;

 private:
  // A horizontal line is taken as falling by half a fine point on its way out, so that centres upon
  // it are in where it is a lower side and out where it is an upper one. The nudge decides exact
  // ties of the others.
  static Line line(FinePoint p) {
    return {p.x / (p.y == 0 ? -0.5 : static_cast<double>(p.y)), -fine_walk::kNudge};
  }

  // A square between those of all distances of whole fine points below the radius and the rest, so
  // that there are no ties.
  static double square_below(std::int64_t radius) {
    constexpr double kSquareCell = 1.0 * FinePoint::kCell * FinePoint::kCell;
    return (static_cast<double>(radius * radius) - 0.5) / kSquareCell;
  }
};

}  // namespace portolan
