// SPDX-License-Identifier: BSD-3-Clause
#include "grid/reference_region.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace portolan {
namespace {

using Point = ReferenceRegion::Point;

// Is the centre in the rows of the edge, and right of it or upon it? In integers.
bool is_right_of(Point a, Point b, Point c) {
  if ((a.y <= c.y) == (b.y <= c.y)) return false;
  const std::int64_t dy = b.y - a.y;
  const std::int64_t side = (c.x - a.x) * dy - (c.y - a.y) * (b.x - a.x);
  return dy > 0 ? side >= 0 : side <= 0;
}

// Even-odd: a centre on a left or lower edge is in, on a right or upper one out.
bool in_polygon(const std::vector<Point>& p, Point c) {
  bool in = false;
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
    if (is_right_of(p[i], p[j], c)) in = !in;
  }
  return in;
}

// The same of the edges of any number of polygons.
bool in_edges(const std::vector<Point>& p, Point c) {
  bool in = false;
  for (std::size_t i = 0; i < p.size(); i += 2) {
    if (is_right_of(p[i], p[i + 1], c)) in = !in;
  }
  return in;
}

// `low` is the corner of the cell.
bool under_ray(const std::vector<Point>& ray, Point low) {
  Point a = ray[0];
  Point b = ray[1];
  if (std::abs(b.y - a.y) < std::abs(b.x - a.x)) {
    a = {a.y, a.x};
    b = {b.y, b.x};
    low = {low.y, low.x};
  }
  if (a.y > b.y) std::swap(a, b);
  const std::int64_t y = low.y + 512;
  if (y < a.y || y >= b.y) return false;
  const std::int64_t dy = b.y - a.y;
  const std::int64_t x = a.x * dy + (y - a.y) * (b.x - a.x);
  return low.x * dy <= x && x < (low.x + 1024) * dy;
}

bool in_cone(const ReferenceRegion& r, Point c) {
  const std::int64_t square = c.x * c.x + c.y * c.y;
  if (square >= r.outer * r.outer || square < r.inner * r.inner) return false;
  for (std::size_t i = 0; i + 1 < r.points.size(); ++i) {
    if (in_polygon({{0, 0}, r.points[i], r.points[i + 1]}, c)) return true;
  }
  return false;
}

bool in_cell(Point low, Point p) {
  return low.x <= p.x && p.x < low.x + 1024 && low.y <= p.y && p.y < low.y + 1024;
}

}  // namespace

bool ReferenceRegion::contains(Point low) const {
  const Point centre{low.x + 512, low.y + 512};
  switch (shape) {
    case Shape::polygon:
      return in_polygon(points, centre);
    case Shape::edges:
      return in_edges(points, centre);
    case Shape::ray:
      return under_ray(points, low);
    case Shape::cone:
      return in_cone(*this, centre);
    case Shape::cell:
      break;
  }
  return in_cell(low, points[0]);
}

std::pair<Point, Point> ReferenceRegion::box() const {
  Point min = points[0];
  Point max = min;
  for (Point p : points) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  if (shape == Shape::cone) {
    min = {std::min(min.x, -outer), std::min(min.y, -outer)};
    max = {std::max(max.x, outer), std::max(max.y, outer)};
  }
  return {min, max};
}

}  // namespace portolan
