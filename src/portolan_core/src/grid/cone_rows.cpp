// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cone_rows.hpp"

#include <cmath>
#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define PORTOLAN_X86 1
#endif

namespace portolan {

namespace {

constexpr double kFar = 1e5;  // [cell]: beyond every footprint

// So many rows at once, as vectors of the compiler, which become those of the processor that a
// function is compiled for.
struct OneRow {
  static constexpr std::size_t kCount = 1;
  using Doubles = double __attribute__((vector_size(8)));
  using Ints = std::int32_t __attribute__((vector_size(4)));
  using Words = std::uint64_t __attribute__((vector_size(8)));
};
struct FourRows {
  static constexpr std::size_t kCount = 4;
  using Doubles = double __attribute__((vector_size(32)));
  using Ints = std::int32_t __attribute__((vector_size(16)));
  using Words = std::uint64_t __attribute__((vector_size(32)));
};
struct EightRows {
  static constexpr std::size_t kCount = 8;
  using Doubles = double __attribute__((vector_size(64)));
  using Ints = std::int32_t __attribute__((vector_size(32)));
  using Words = std::uint64_t __attribute__((vector_size(64)));
};

template <class Rows>
class Pen {
 public:
  static bool draw(const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end,
                   TileBits& free, TileBits& occupied) {
    Words any{};
    for (std::size_t first = begin & ~(Rows::kCount - 1); first < end; first += Rows::kCount) {
      Words freed{};
      Words all{};
      draw(cone, x, middles() + (static_cast<double>(first) - y), freed, all);
      const Words hit = all & ~freed;
      std::memcpy(&free[first], &freed, sizeof(freed));
      std::memcpy(&occupied[first], &hit, sizeof(hit));
      any |= all;
    }
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < Rows::kCount; ++i) all |= any[i];
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
    for (std::size_t i = 0; i < Rows::kCount; ++i) middles[i] = static_cast<double>(i) + 0.5;
    return middles;
  }
  static Doubles min(Doubles a, Doubles b) { return a < b ? a : b; }
  static Doubles max(Doubles a, Doubles b) { return a > b ? a : b; }
  static Doubles sqrt(Doubles a) {
    for (std::size_t i = 0; i < Rows::kCount; ++i) a[i] = std::sqrt(a[i]);
    return a;
  }
};

#ifdef PORTOLAN_X86

[[gnu::target("avx512f,avx512dq,avx512vl"), gnu::flatten]] bool draw_rows_avx512(
    const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end, TileBits& free,
    TileBits& occupied) {
  return Pen<EightRows>::draw(cone, x, y, begin, end, free, occupied);
}

[[gnu::target("avx2"), gnu::flatten]] bool draw_rows_avx2(const ConeRows& cone, double x, double y,
                                                          std::size_t begin, std::size_t end,
                                                          TileBits& free, TileBits& occupied) {
  return Pen<FourRows>::draw(cone, x, y, begin, end, free, occupied);
}

#endif

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

bool cone_rows_detail::draw_rows_portably(const ConeRows& cone, double x, double y,
                                          std::size_t begin, std::size_t end, TileBits& free,
                                          TileBits& occupied) {
  return Pen<OneRow>::draw(cone, x, y, begin, end, free, occupied);
}

bool draw_rows(const ConeRows& cone, double x, double y, std::size_t begin, std::size_t end,
               TileBits& free, TileBits& occupied) {
#ifdef PORTOLAN_X86
  static const bool kHasAvx512 = __builtin_cpu_supports("avx512dq") != 0;
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
  if (kHasAvx512) return draw_rows_avx512(cone, x, y, begin, end, free, occupied);
  if (kHasAvx2) return draw_rows_avx2(cone, x, y, begin, end, free, occupied);
#endif
  return cone_rows_detail::draw_rows_portably(cone, x, y, begin, end, free, occupied);
}

}  // namespace portolan
