// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace portolan {

namespace {

constexpr int kFineLog2 = Footprint::kFineLog2;
constexpr int kFine = Footprint::kFine;
constexpr int kSide = TileMap::kSide;
constexpr int kMaxSide = 8500;  // of a window [cell]: keeps the walks exact

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
  for (std::vector<std::uint8_t>* marks : {&is_toggled_, &is_free_, &is_occupied_}) {
    if (marks->size() * kSide < words) marks->resize(words / kSide);
  }
  return true;
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
    is_free_[tile_at(column, row)] = 1;
  };
  if (std::abs(b.y - a.y) >= std::abs(b.x - a.x)) {
    fine_walk::walk_rows(a, b, fine_walk::kNudge, [&](int row, int column) { mark(column, row); });
  } else {
    fine_walk::walk_rows({a.y, a.x}, {b.y, b.x}, fine_walk::kNudge,
                         [&](int column, int row) { mark(column, row); });
  }
}

void Footprint::occupy(FinePoint p) {
  p = in_window(p);
  const int column = p.x >> kFineLog2;
  const int row = p.y >> kFineLog2;
  word(occupied_, column, row) |= Word{1} << (column & 63);
  is_occupied_[tile_at(column, row)] = 1;
}

void Footprint::cone(FinePoint b, FinePoint c, std::int64_t free, std::int64_t occupied) {
  const std::array<FinePoint, 3> corners = {in_window({0, 0}), in_window(b), in_window(c)};
  const std::int64_t reach = std::max(free, occupied);
  spans_.assign(static_cast<std::size_t>(rows_), Span{});
  for (std::size_t i = 0; i < 3; ++i) {
    fine_walk::walk_rows(corners[i], corners[(i + 1) % 3], 0.5 - fine_walk::kNudge,
                         [this](int row, int column) {
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
    const int begin = std::max(span.begin, fine_walk::first_centre(centre.x - half));
    const int end = std::min(span.end, fine_walk::first_centre(centre.x + half + 1));
    if (begin >= end) continue;
    toggle_from(begin, row);
    toggle_from(end, row);
  }
}

void Footprint::settle(std::vector<Word>& into, FinePoint min, FinePoint max) {
  std::vector<std::uint8_t>& marks = &into == &free_ ? is_free_ : is_occupied_;
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
      if (inside != 0) marks[tile_at(strip * 64, row)] = 1;
    }
  }
}

CellRect Footprint::apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) {
  bool is_empty = true;
  for (int band = 0; band < rows_ / kSide; ++band) {
    carry_.fill(0);
    carries_ = false;
    for (int strip = 0; strip < strips_; ++strip) {
      if (!take_bits(strip, band)) continue;
      TileMap::Tile& tile = map.at({tile_.x + strip, tile_.y + band});
      tile.revision = revision;
      is_empty = false;
      update_cells(tile, freed_, hit_, update);
    }
  }
  return is_empty ? CellRect{} : covered_;
}

// Moves the bits of a tile to freed_ and hit_ and clears them here; false where there are none.
bool Footprint::take_bits(int strip, int band) {
  const std::size_t tile = tile_at(strip * kSide, band * kSide);
  if (!carries_ && !is_toggled_[tile] && !is_free_[tile] && !is_occupied_[tile]) return false;
  const std::size_t first = static_cast<std::size_t>(strip * rows_ + band * kSide);
  freed_ = carry_;
  hit_.fill(0);
  if (std::exchange(is_toggled_[tile], std::uint8_t{0}) != 0) take_toggled(&toggled_[first]);
  if (std::exchange(is_free_[tile], std::uint8_t{0}) != 0) {
    for (std::size_t i = 0; i < kSide; ++i) freed_[i] |= std::exchange(free_[first + i], 0);
  }
  if (std::exchange(is_occupied_[tile], std::uint8_t{0}) != 0) {
    for (std::size_t i = 0; i < kSide; ++i) hit_[i] = std::exchange(occupied_[first + i], 0);
  }
  return true;
}

void Footprint::take_toggled(Word* toggled) {
  Word any = 0;
  for (std::size_t i = 0; i < kSide; ++i) {
    freed_[i] ^= toggled[i];
    carry_[i] = Word{0} - (freed_[i] >> 63);
    any |= carry_[i];
    toggled[i] = 0;
  }
  carries_ = any != 0;
}

}  // namespace portolan
