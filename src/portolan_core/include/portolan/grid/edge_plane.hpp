// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace portolan {

/// A footprint's plane of edges, with all at hand that stays the same along an edge.
struct EdgePlane {
  std::uint64_t* words;
  std::uint8_t* marks;
  std::ptrdiff_t rows;
  std::ptrdiff_t bands;

  /// Counts an edge left of the cell in this column, and so of all right of it in its word.
  void toggle_from(int column, int row) const {
    const std::ptrdiff_t strip = column >> 6;
    words[strip * rows + row] ^= ~std::uint64_t{0} << (column & 63);
    marks[strip * bands + (row >> 6)] = 1;
  }
};

}  // namespace portolan
