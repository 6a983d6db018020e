// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "portolan/grid/cell_rows.hpp"
#include "portolan/grid/fine_walk.hpp"

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

  /// Adds the wedge of at most a quarter turn that reaches from `right` counterclockwise to `left`,
  /// where its sides pass these points.
  void add(FinePoint right, FinePoint left);

  /// What is free lies nearer to the apex than `free`, what is occupied from there to `reach`, in
  /// 1/1024 of a cell.
  void set_radii(std::int64_t free, std::int64_t reach);

  std::array<Wedge, 4> wedges;
  std::size_t count = 0;  // of wedges
  double free_square = 0.0;
  double reach_square = 0.0;
};

/// Draws the rows [begin, end) of a tile that has the apex at (x, y) from its corner. The cone must
/// not reach into other rows of the tile, which may be drawn as well. False where it has no cell
/// there. With the widest vectors that the processor has; the result does not depend on it.
bool draw_rows(const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end,
               TileBits& free, TileBits& occupied);

namespace cone_rows_detail {

/// The same without the vectors of particular processors.
bool draw_rows_portably(const ConeRows& cone, double x, double y, std::size_t begin,
                        std::size_t end, TileBits& free, TileBits& occupied);

}  // namespace cone_rows_detail

}  // namespace portolan
