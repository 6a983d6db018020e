// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cone_rows.hpp"

#include <cmath>
#include <cstring>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

constexpr double kFar = 1e5;  // [cell]: beyond every footprint

template <class Rows>
class Pen {
 public:
  static bool draw(const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end,
                   TileBits& free, TileBits& occupied) {
    Words any{};
    constexpr std::size_t kCount = Rows::kCount;
    for (std::size_t first = begin & ~(kCount - 1); first < end; first += kCount) {
      Words freed{};
      Words all{};
      draw(cone, x, middles() + (static_cast<double>(first) - y), freed, all);
      const Words hit = all & ~freed;
      std::memcpy(&free[first], &freed, sizeof(freed));
      std::memcpy(&occupied[first], &hit, sizeof(hit));
      any |= all;
    }
    std::uint64_t all = 0;
    for (int i = 0; i < Rows::kCount; ++i) all |= any[i];
    return all != 0;
  }

 private:
  using Doubles = typename Rows::Doubles;
  using Words = typename Rows::Words;

  static void draw(const ConeRows& cone, double x, Doubles y, Words& freed, Words& all) {
    const Doubles near = half_width(cone.free_square, y);
    const Doubles far = half_width(cone.reach_square, y);
    for (std::size_t i = 0; i < cone.count; ++i) {
      const ConeRows::Wedge& wedge = cone.wedges[i];
      const Doubles from = max(x_of(wedge.from[0], y), x_of(wedge.from[1], y));
      const Doubles to = min(x_of(wedge.to[0], y), x_of(wedge.to[1], y));
      freed |= bits_from(x + max(from, -near)) & ~bits_from(x + min(to, near));
      all |= bits_from(x + max(from, -far)) & ~bits_from(x + min(to, far));
    }
  }

  static Doubles x_of(const ConeRows::Line& line, Doubles y) {
    return line.slope * y + line.offset;
  }

  // Half the width of a disc; negative where the disc does not reach the row.
  static Doubles half_width(double square_radius, Doubles y) {
    const Doubles rest = square_radius - y * y;
    return rest < 0.0 ? Doubles{} - kFar : sqrt(max(rest, Doubles{}));
  }

  // The bits of the columns whose centres lie at x or right of it.
  static Words bits_from(Doubles x) {
    const Doubles limited = min(max(x + 0.5, Doubles{}), Doubles{} + TileMap::kSide);
    const auto column = __builtin_convertvector(limited, typename Rows::Ints);
    const Words count = __builtin_convertvector(column, Words);
    return ~Words{} << (count >> 1) << (count - (count >> 1));  // by 64 in two halves
  }

  static Doubles middles() {
    Doubles middles{};
    for (int i = 0; i < Rows::kCount; ++i) middles[i] = i + 0.5;
    return middles;
  }
  static Doubles min(Doubles a, Doubles b) { return a < b ? a : b; }
  static Doubles max(Doubles a, Doubles b) { return a > b ? a : b; }
  static Doubles sqrt(Doubles a) {
    for (int i = 0; i < Rows::kCount; ++i) a[i] = std::sqrt(a[i]);
    return a;
  }
};

// A horizontal line is taken as falling by half a fine point on its way out, so that centres upon
// it are in where it is a lower side and out where it is an upper one. The nudge decides exact ties
// of the others.
ConeRows::Line line(FinePoint p) {
  return {p.x / (p.y == 0 ? -0.5 : static_cast<double>(p.y)), -fine_walk::kNudge};
}

// A square between those of all distances of whole fine points below the radius and the rest, so
// that there are no ties.
double square_below(std::int64_t radius) {
  constexpr double kSquareCell = 1.0 * FinePoint::kCell * FinePoint::kCell;
  return (static_cast<double>(radius * radius) - 0.5) / kSquareCell;
}

}  // namespace

void ConeRows::add(FinePoint right, FinePoint left) {
  Wedge& wedge = wedges[count++];
  wedge.from = {Line{0.0, -kFar}, Line{0.0, -kFar}};
  wedge.to = {Line{0.0, kFar}, Line{0.0, kFar}};
  (right.y > 0 ? wedge.to : wedge.from)[0] = line(right);
  (left.y > 0 ? wedge.from : wedge.to)[1] = line(left);
}

void ConeRows::set_radii(std::int64_t free, std::int64_t reach) {
  free_square = square_below(free);
  reach_square = square_below(reach);
}

bool draw_rows(const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end,
               TileBits& free, TileBits& occupied) {
  return with_widest_rows(
      [&](auto by) { return Pen<decltype(by)>::draw(cone, x, y, begin, end, free, occupied); });
}

bool cone_rows_detail::draw_rows_portably(const ConeRows& cone, double x, double y,
                                          std::size_t begin, std::size_t end, TileBits& free,
                                          TileBits& occupied) {
  return Pen<TwoRows>::draw(cone, x, y, begin, end, free, occupied);
}

}  // namespace portolan
