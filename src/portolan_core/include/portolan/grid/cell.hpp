// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace portolan {

/// A square of a grid map: (x, y) reaches from x to x + 1 cell sides, and so does y.
struct Cell {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

constexpr bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
constexpr bool operator!=(Cell a, Cell b) { return !(a == b); }

/// A rectangle of cells: `min` lies in it, `max` is the first corner beyond it.
struct CellRect {
  Cell min;
  Cell max;

  bool empty() const { return max.x <= min.x || max.y <= min.y; }
  int width() const { return empty() ? 0 : max.x - min.x; }
  int height() const { return empty() ? 0 : max.y - min.y; }
  bool contains(Cell c) const { return min.x <= c.x && c.x < max.x && min.y <= c.y && c.y < max.y; }
};

inline bool operator==(const CellRect& a, const CellRect& b) {
  return a.min == b.min && a.max == b.max;
}

/// The smallest rectangle around both; an empty one adds nothing.
inline CellRect united(const CellRect& a, const CellRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

/// What lies in both.
inline CellRect intersected(const CellRect& a, const CellRect& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

}  // namespace portolan
