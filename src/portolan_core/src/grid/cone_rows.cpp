// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cone_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "portolan/grid/row_update.hpp"
#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;

// From the lower end of a tile [cell].
double from_tile(std::int64_t fine, int tile) {
  constexpr std::int64_t kFineSide = std::int64_t{kSide} * FinePoint::kCell;
  return static_cast<double>(fine - tile * kFineSide) / FinePoint::kCell;
}

Cell tile_of(Cell cell) { return {cell.x >> TileMap::kSideLog2, cell.y >> TileMap::kSideLog2}; }

/// Draws a cone, by two bands of tiles. Roots take long: while those of the first band are on their
/// way, those of the second one can start.
template <class Rows>
class Pen {
 public:
  Pen(const ConeRows& cone, TileMap& map, const CellUpdate& update, std::uint64_t revision)
      : cone_(cone), map_(map), update_(update), revision_(revision) {}

  bool draw() {
    const Cell first = tile_of(cone_.covered.min);
    const Cell last = tile_of({cone_.covered.max.x - 1, cone_.covered.max.y - 1});
    bool is_empty = true;
    for (int y = first.y; y <= last.y; y += 2) {
      const int end = std::min(y + 2, last.y + 1);
      for (int band = y; band < end; ++band) find_spans(band);
      for (int band = y; band < end; ++band) {
        for (int x = first.x; x <= last.x; ++x) is_empty = !draw_tile({x, band}) && is_empty;
      }
    }
    return !is_empty;
  }

 private:
  using Doubles = typename Rows::Doubles;
  using Words = typename Rows::Words;
  static constexpr std::size_t kCount = Rows::kCount;

  /// Where a wedge lies in a few rows.
  struct Spans {
    Doubles from, free_from, free_to, to;
  };

  // The covered rows of a band from its first one on, or from so much lower that whole steps end in
  // the band.
  std::size_t begin(int band) const {
    const int row = std::max(0, cone_.covered.min.y - band * kSide);
    const int steps = (static_cast<int>(end(band)) - row + Rows::kCount - 1) / Rows::kCount;
    return static_cast<std::size_t>(std::min(row, kSide - steps * Rows::kCount));
  }
  std::size_t end(int band) const {
    return static_cast<std::size_t>(std::min(kSide, cone_.covered.max.y - band * kSide));
  }

  Spans* spans(int band, std::size_t row) { return spans_[band & 1][row / kCount].data(); }

  void find_spans(int band) {
    const double y_apex = from_tile(cone_.apex.y, band);
    const std::size_t last = end(band);
    for (std::size_t row = begin(band); row < last; row += kCount) {
      const Doubles y = middles() + (static_cast<double>(row) - y_apex);
      const Doubles near = half_width(cone_.free_square, y);
      const Doubles far = half_width(cone_.reach_square, y);
      for (std::size_t i = 0; i < cone_.count; ++i) {
        const ConeRows::Wedge& wedge = cone_.wedges[i];
        const Doubles from = max(x_of(wedge.from[0], y), x_of(wedge.from[1], y));
        const Doubles to = min(x_of(wedge.to[0], y), x_of(wedge.to[1], y));
        spans(band, row)[i] = {max(from, -far), max(from, -near), min(to, near), min(to, far)};
      }
    }
  }

  // False where the cone has no cell in the tile.
  bool draw_tile(Cell index) {
    const double x = from_tile(cone_.apex.x, index.x);
    const std::size_t first = begin(index.y);
    const std::size_t last = end(index.y);
    Words any{};
    for (std::size_t row = first; row < last; row += kCount) {
      Words free{};
      Words all{};
      for (std::size_t i = 0; i < cone_.count; ++i) {
        const Spans& s = spans(index.y, row)[i];
        free |= bits_from(x + s.free_from) & ~bits_from(x + s.free_to);
        all |= bits_from(x + s.from) & ~bits_from(x + s.to);
      }
      free_[row / kCount] = free;
      occupied_[row / kCount] = all & ~free;
      any |= all;
    }
    if (is_zero(any)) return false;
    TileMap::Tile& tile = map_.at(index);
    tile.revision = revision_;
    const RowUpdate<Rows> update = update_;
    for (std::size_t row = first; row < last; row += kCount) {
      update(tile.row(static_cast<int>(row)), free_[row / kCount], occupied_[row / kCount]);
    }
    return true;
  }

  static bool is_zero(Words words) {
    std::uint64_t any = 0;
    for (int i = 0; i < Rows::kCount; ++i) any |= words[i];
    return any == 0;
  }

  static Doubles x_of(const ConeRows::Line& line, Doubles y) {
    return line.slope * y + line.offset;
  }

  // Half the width of a disc; negative where the disc does not reach the row.
  static Doubles half_width(double square_radius, Doubles y) {
    const Doubles rest = square_radius - y * y;
    return rest < 0.0 ? Doubles{} - ConeRows::kFar : sqrt(rest);
  }

  // The bits of the columns whose centres lie right of x; none lies at it. Adding so large a number
  // rounds, and leaves what was rounded in the lowest bits.
  static Words bits_from(Doubles x) {
    constexpr double kLarge = 0x1p52;
    const Doubles rounded = max(x, Doubles{} + 0.25) + kLarge;
    Words count;
    std::memcpy(&count, &rounded, sizeof(count));
    return rounded < kLarge + kSide ? ~Words{} << (count & (kSide - 1)) : Words{};
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

  const ConeRows& cone_;
  TileMap& map_;
  RowUpdate<Rows> update_;
  std::uint64_t revision_;
  using Band = std::array<std::array<Spans, ConeRows::kMaxWedges>, kSide / kCount>;
  std::array<Band, 2> spans_;
  // Of the tile at hand.
  std::array<Words, kSide / kCount> free_;
  std::array<Words, kSide / kCount> occupied_;
};

}  // namespace

bool ConeRows::apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const {
  return with_widest_rows(
      [&](auto by) { return Pen<decltype(by)>(*this, map, update, revision).draw(); });
}

bool ConeRows::apply_portably(TileMap& map, const CellUpdate& update,
                              std::uint64_t revision) const {
  return Pen<TwoRows>(*this, map, update, revision).draw();
}

}  // namespace portolan
