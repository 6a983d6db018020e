// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace portolan {

namespace {

constexpr int kFineLog2 = Footprint::kFineLog2;
constexpr int kFine = Footprint::kFine;
constexpr int kSide = TileMap::kSide;
constexpr int kMaxSide = 8500;  // of a window [cell]: keeps the fixed-point numbers below exact

// Crossings are followed in fixed point with so many binary places of a cell. Inside a window two
// different crossings of edges and centres differ by 2^-33 cells or more, and all errors together
// stay below the nudge that decides exact ties.
constexpr int kPlaces = 49;
constexpr double kNudge = 0x1p-35;

// The first row (or column) whose centre lies at p or beyond.
int first_centre(std::int32_t p) { return (p + kFine / 2 - 1) >> kFineLog2; }

// Calls visit(row, floor(x + offset)) for every row whose centre lies in [a.y, b.y), where x is the
// line's position at that centre, in cells.
template <class Visit>
void walk_rows(FinePoint a, FinePoint b, double offset, Visit visit) {
  if (a.y > b.y) std::swap(a, b);
  int row = first_centre(a.y);
  const int end = first_centre(b.y);
  if (row >= end) return;
  const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
  const double to_first = row * kFine + kFine / 2 - a.y;
  const double x = (a.x + to_first * slope) / kFine + offset;
  auto position = static_cast<std::int64_t>(x * 0x1p49);
  const auto step = static_cast<std::int64_t>(slope * 0x1p49);
  for (; row < end; ++row, position += step) visit(row, static_cast<int>(position >> kPlaces));
}

// 64 bytes of 0 or 0xFF, one for each bit.
struct ByteMask {
  alignas(64) std::array<std::uint8_t, kSide> bytes;
};

constexpr std::array<std::uint64_t, 256> make_spread() {
  std::array<std::uint64_t, 256> spread{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    std::array<std::uint8_t, 8> bytes{};
    for (std::size_t i = 0; i < 8; ++i) bytes[i] = (bits >> i) & 1 ? 0xFF : 0;
    for (std::size_t i = 0; i < 8; ++i) {
      spread[bits] |= std::uint64_t{bytes[i]} << (8 * i);
    }
  }
  return spread;
}
constexpr std::array<std::uint64_t, 256> kSpread = make_spread();

void spread(std::uint64_t bits, ByteMask& mask) {
  for (std::size_t i = 0; i < 8; ++i) {
    const std::uint64_t eight = kSpread[(bits >> (8 * i)) & 0xFF];
    std::memcpy(&mask.bytes[8 * i], &eight, 8);
  }
}

CellByte known(CellByte cell, CellByte prior) { return cell == kNeverObserved ? prior : cell; }
CellByte freed(CellByte cell, const CellUpdate& u) {
  return static_cast<CellByte>(std::max(known(cell, u.prior), u.free_floor) - u.free_step);
}
CellByte hit(CellByte cell, const CellUpdate& u) {
  return static_cast<CellByte>(std::min(known(cell, u.prior), u.occupied_ceiling) +
                               u.occupied_step);
}

void free_row(CellByte* row, const CellUpdate& update) {
  const CellUpdate u = update;
  for (int i = 0; i < kSide; ++i) row[i] = freed(row[i], u);
}

void update_row(CellByte* row, std::uint64_t free, std::uint64_t occupied,
                const CellUpdate& update) {
  ByteMask is_free;
  ByteMask is_occupied;
  spread(free, is_free);
  spread(occupied, is_occupied);
  const CellUpdate u = update;
  for (std::size_t i = 0; i < kSide; ++i) {
    const std::uint8_t f = is_free.bytes[i];
    const std::uint8_t o = is_occupied.bytes[i];
    row[i] =
        static_cast<CellByte>((freed(row[i], u) & f) | (hit(row[i], u) & o) | (row[i] & ~(f | o)));
  }
}

}  // namespace

bool Footprint::open(Anchor anchor, FinePoint min, FinePoint max) {
  const auto cell = [](std::int64_t fine) { return static_cast<std::int32_t>(fine >> kFineLog2); };
  covered_ = {{cell(anchor.x + min.x), cell(anchor.y + min.y)},
              {cell(anchor.x + max.x) + 1, cell(anchor.y + max.y) + 1}};
  if (covered_.width() > kMaxSide || covered_.height() > kMaxSide) return false;
  tile_ = {covered_.min.x >> 6, covered_.min.y >> 6};
  const auto corner = [](std::int32_t tile) { return std::int64_t{tile} * kSide * kFine; };
  shift_ = {static_cast<std::int32_t>(anchor.x - corner(tile_.x)),
            static_cast<std::int32_t>(anchor.y - corner(tile_.y))};
  strips_ = (covered_.max.x >> 6) - tile_.x + 1;  // with the column after the last one
  rows_ = (((covered_.max.y - 1) >> 6) - tile_.y + 1) * kSide;
  const auto words = static_cast<std::size_t>(strips_ * rows_);
  for (std::vector<Word>* plane : {&toggled_, &free_, &occupied_}) {
    if (plane->size() < words) plane->resize(words);
  }
  carry_.assign(static_cast<std::size_t>(rows_), 0);
  return true;
}

void Footprint::toggle(FinePoint a, FinePoint b) {
  // The first column whose centre lies at x or right of it is ceil(x - 1/2).
  walk_rows(in_window(a), in_window(b), 0.5 - kNudge,
            [this](int row, int column) { toggle_from(column, row); });
}

void Footprint::fill(std::vector<Word>& into, const FinePoint* corners, int count) {
  FinePoint min = corners[0];
  FinePoint max = corners[0];
  for (int i = 0; i < count; ++i) {
    const FinePoint& p = corners[i];
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    toggle(p, corners[i + 1 < count ? i + 1 : 0]);
  }
  settle(into, min, max);
}

void Footprint::ray(FinePoint a, FinePoint b) {
  a = in_window(a);
  b = in_window(b);
  const auto mark = [this](int column, int row) {
    word(free_, column, row) |= Word{1} << (column & 63);
  };
  if (std::abs(b.y - a.y) >= std::abs(b.x - a.x)) {
    walk_rows(a, b, kNudge, [&](int row, int column) { mark(column, row); });
  } else {
    walk_rows({a.y, a.x}, {b.y, b.x}, kNudge, [&](int column, int row) { mark(column, row); });
  }
}

void Footprint::occupy(FinePoint p) {
  p = in_window(p);
  const int column = p.x >> kFineLog2;
  word(occupied_, column, p.y >> kFineLog2) |= Word{1} << (column & 63);
}

void Footprint::cone(FinePoint b, FinePoint c, std::int64_t free, std::int64_t occupied) {
  const std::array<FinePoint, 3> corners = {in_window({0, 0}), in_window(b), in_window(c)};
  const std::int64_t reach = std::max(free, occupied);
  spans_.assign(static_cast<std::size_t>(rows_), Span{});
  for (std::size_t i = 0; i < 3; ++i) {
    walk_rows(corners[i], corners[(i + 1) % 3], 0.5 - kNudge, [this](int row, int column) {
      if (row < 0 || row >= rows_) return;
      Span& span = spans_[static_cast<std::size_t>(row)];
      span = {std::min(span.begin, column), std::max(span.end, column)};
    });
  }
  const FinePoint min{static_cast<std::int32_t>(-reach), static_cast<std::int32_t>(-reach)};
  const FinePoint max{static_cast<std::int32_t>(reach), static_cast<std::int32_t>(reach)};
  toggle_disc(free);
  settle(free_, min, max);
  if (occupied <= free) return;
  toggle_disc(free);
  toggle_disc(occupied);
  settle(occupied_, min, max);
}

void Footprint::toggle_disc(std::int64_t radius) {
  const FinePoint centre = in_window({0, 0});
  for (int row = 0; row < rows_; ++row) {
    const std::int64_t dy = std::int64_t{row} * kFine + kFine / 2 - centre.y;
    const std::int64_t square = radius * radius - 1 - dy * dy;  // of a distance below the radius
    if (square < 0) continue;
    const auto half = static_cast<std::int32_t>(std::sqrt(static_cast<double>(square)));
    const Span& span = spans_[static_cast<std::size_t>(row)];
    const int begin = std::max(span.begin, first_centre(centre.x - half));
    const int end = std::min(span.end, first_centre(centre.x + half + 1));
    if (begin >= end) continue;
    toggle_from(begin, row);
    toggle_from(end, row);
  }
}

void Footprint::settle(std::vector<Word>& into, FinePoint min, FinePoint max) {
  min = in_window(min);
  max = in_window(max);
  const int first_row = std::max(0, min.y >> kFineLog2);
  const int last_row = std::min(rows_ - 1, max.y >> kFineLog2);
  const int first_strip = std::max(0, min.x >> (kFineLog2 + 6));
  const int last_strip = std::min(strips_ - 1, ((max.x >> kFineLog2) + 1) >> 6);
  for (int row = first_row; row <= last_row; ++row) {
    Word carry = 0;
    for (int strip = first_strip; strip <= last_strip; ++strip) {
      Word& toggled = word(toggled_, strip * 64, row);
      const Word inside = toggled ^ carry;
      toggled = 0;
      carry = Word{0} - (inside >> 63);
      word(into, strip * 64, row) |= inside;
    }
  }
}

CellRect Footprint::apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) {
  for (int strip = 0; strip < strips_; ++strip) {
    for (int first_row = 0; first_row < rows_; first_row += kSide) {
      apply_tile(map, strip, first_row, update, revision);
    }
  }
  return covered_;
}

void Footprint::apply_tile(TileMap& map, int strip, int first_row, const CellUpdate& update,
                           std::uint64_t revision) {
  const std::size_t first = static_cast<std::size_t>(strip * rows_ + first_row);
  std::array<Word, kSide> inside;
  Word any = 0;
  for (std::size_t i = 0; i < kSide; ++i) {
    Word& carry = carry_[static_cast<std::size_t>(first_row) + i];
    const Word parity = toggled_[first + i] ^ carry;
    carry = Word{0} - (parity >> 63);
    inside[i] = parity | free_[first + i];
    any |= inside[i] | occupied_[first + i];
    toggled_[first + i] = 0;
    free_[first + i] = 0;
  }
  if (any == 0) return;
  TileMap::Tile& tile = map.at({tile_.x + strip, tile_.y + (first_row >> 6)});
  tile.revision = revision;
  for (std::size_t i = 0; i < kSide; ++i) {
    const Word occupied = std::exchange(occupied_[first + i], 0);
    const Word free = inside[i] & ~occupied;
    if ((free | occupied) == 0) continue;
    CellByte* row = tile.row(static_cast<int>(i));
    if (free == ~Word{0}) {
      free_row(row, update);
    } else {
      update_row(row, free, occupied, update);
    }
  }
}

}  // namespace portolan
