// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace portolan {

/// A part of the plane that a sensor says is free or occupied, as the slow grid map asks for it.
struct ReferenceRegion {
  struct Point {
    std::int64_t x, y;  // in 1/1024 of a cell, from the sensor's anchor
  };
  enum class Shape { polygon, edges, ray, cone, cell };

  Shape shape;
  bool occupied;
  std::vector<Point> points;  // of edges: two each; of a cone: its rim, seen from the anchor
  std::int64_t inner = 0, outer = 0;  // of a cone

  /// True if the cell whose lower corner is `low` belongs to the region, by draw.hpp.
  bool contains(Point low) const;

  /// Lower and upper corner of a box about the region.
  std::pair<Point, Point> box() const;
};

}  // namespace portolan
