// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace portolan {

/// A point of the plane in 1/1024 of a cell's side, counted from an anchor.
struct FinePoint {
  static constexpr int kCellLog2 = 10;
  static constexpr int kCell = 1 << kCellLog2;  ///< a cell's side

  std::int32_t x = 0;
  std::int32_t y = 0;
};

namespace fine_walk {

// Lines are followed in fixed point with so many binary places of a cell. Among points within 8500
// cells two different crossings of lines and centres differ by 2^-33 cells or more, and all errors
// together stay below the nudge that decides exact ties.
inline constexpr int kPlaces = 49;
inline constexpr double kNudge = 0x1p-35;

/// The first row (or column) whose centre lies at `p` or beyond.
inline int first_centre(std::int32_t p) {
  return (p + FinePoint::kCell / 2 - 1) >> FinePoint::kCellLog2;
}

/// Does a line between these pass the centre of a row?
inline bool passes_row(FinePoint a, FinePoint b) { return first_centre(a.y) != first_centre(b.y); }

/// A line on its way through the rows whose centres lie in [a.y, b.y) or [b.y, a.y); there must be
/// some.
struct Walk {
  int row = 0;                ///< the first one
  int end = 0;                ///< the one after the last
  std::int64_t position = 0;  ///< x + offset at the first row's centre, in cells, fixed point
  std::int64_t step = 0;      ///< from row to row

  /// Coordinates must not be negative.
  Walk(FinePoint a, FinePoint b, double offset) {
    const int above_a = first_centre(a.y);
    const int above_b = first_centre(b.y);
    row = std::min(above_a, above_b);
    end = std::max(above_a, above_b);
    const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
    constexpr int kHalf = FinePoint::kCell / 2;
    const double to_first = row * FinePoint::kCell + kHalf - a.y;
    const double x = (a.x + to_first * slope) * (1.0 / FinePoint::kCell) + offset;
    position = static_cast<std::int64_t>(x * 0x1p49);
    const double makes_steps = std::min(end - row - 1, 1);  // one row may be too flat for one
    step = static_cast<std::int64_t>(makes_steps * slope * 0x1p49);
  }

  std::int64_t at(int in_row) const { return position + (in_row - row) * step; }
};

/// Calls visit(row, floor(x + offset)) for every row whose centre lies in [a.y, b.y) or [b.y, a.y),
/// where x is the line's position at that centre, in cells. Coordinates must not be negative.
template <class Visit>
void walk_rows(FinePoint a, FinePoint b, double offset, Visit visit) {
  if (!passes_row(a, b)) return;
  const Walk walk(a, b, offset);
  for (int row = walk.row; row < walk.end; ++row) {
    visit(row, static_cast<int>(walk.at(row) >> kPlaces));
  }
}

}  // namespace fine_walk

}  // namespace portolan
