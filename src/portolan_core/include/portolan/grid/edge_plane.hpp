// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "portolan/grid/fine_walk.hpp"

namespace portolan {

/// A footprint's plane of edges, with all at hand that stays the same along an edge.
struct EdgePlane {
  std::uint64_t* words;
  std::uint8_t* marks;  ///< by 64 words: is there something?
  std::ptrdiff_t rows;  ///< a multiple of 64

  /// Counts an edge left of the cell in this column, and so of all right of it in its word.
  void toggle_from(int column, int row) const {
    const std::ptrdiff_t word = (column >> 6) * rows + row;
    words[word] ^= ~std::uint64_t{0} << (column & 63);
    marks[word >> 6] = 1;
  }

  /// Sets the bit of a cell, in a plane that holds no edges but cells.
  void set(int column, int row) const {
    const std::ptrdiff_t word = (column >> 6) * rows + row;
    words[word] |= std::uint64_t{1} << (column & 63);
    marks[word >> 6] = 1;
  }

  /// The same along an edge: in every row whose centre it passes, from the first cell whose centre
  /// lies at it or right of it. Coordinates are those of the plane.
  void toggle(FinePoint a, FinePoint b) const {
    if (std::abs(b.y - a.y) > kLong) return toggle_long(a, b);
    fine_walk::walk_rows(a, b, kOffset,
                         [plane = *this](int row, int column) { plane.toggle_from(column, row); });
  }

  // The first column whose centre lies at x or right of it is ceil(x - 1/2).
  static constexpr double kOffset = 0.5 - fine_walk::kNudge;

 private:
  static constexpr std::int32_t kLong = 16 * FinePoint::kCell;
  void toggle_long(FinePoint a, FinePoint b) const;  // rows by a few, with the same result
};

}  // namespace portolan
