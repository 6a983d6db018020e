// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "portolan/grid/region_rows.hpp"
#include "portolan/grid/row_update.hpp"

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;

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
  first_row_ = covered_.min.y - tile_.y * kSide;
  end_row_ = covered_.max.y - tile_.y * kSide;
  const auto words = static_cast<std::size_t>(strips_) * static_cast<std::size_t>(rows_);
  for (std::vector<Word>* plane : {&toggled_, &struck_, &free_, &occupied_}) {
    if (plane->size() < words) plane->resize(words);
  }
  for (std::vector<std::uint8_t>* marks : {&is_toggled_, &is_struck_, &is_free_, &is_occupied_}) {
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
    outline(p, corners[i + 1 < count ? i + 1 : 0]);
  }
  settle(into, min, max);
}

void Footprint::ray(FinePoint a, FinePoint b) {
  a = in_window(a);
  b = in_window(b);
  const EdgePlane free = edges(free_, is_free_);
  if (std::abs(b.y - a.y) >= std::abs(b.x - a.x)) {
    fine_walk::walk_rows(a, b, fine_walk::kNudge,
                         [free](int row, int column) { free.set(column, row); });
  } else {
    fine_walk::walk_rows({a.y, a.x}, {b.y, b.x}, fine_walk::kNudge,
                         [free](int column, int row) { free.set(column, row); });
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
  const bool any = with_widest_rows([&](auto by) {
    using Rows = decltype(by);
    return put(map, RowUpdate<Rows>(update), revision, by);
  });
  return any ? covered_ : CellRect{};
}

// Takes all bits out of the planes and puts them into a map; false where there are none.
template <class Rows>
bool Footprint::put(TileMap& map, const RowUpdate<Rows>& update, std::uint64_t revision, Rows) {
  bool any = false;
  for (int band = 0; band < rows_ / kSide; ++band) {
    const int begin = std::max(0, first_row_ - band * kSide) & -Rows::kCount;
    const int end = std::min(kSide, end_row_ - band * kSide);
    RegionRows free;
    RegionRows occupied;
    for (int strip = 0; strip < strips_; ++strip) {
      const std::size_t tile = tile_at(strip * kSide, band * kSide);
      free.enter(marked(toggled_, is_toggled_, tile), marked(free_, is_free_, tile));
      occupied.enter(marked(struck_, is_struck_, tile), marked(occupied_, is_occupied_, tile));
      if (free.is_empty() && occupied.is_empty()) continue;
      any = true;
      TileMap::Tile& cells = map.at({tile_.x + strip, tile_.y + band});
      cells.revision = revision;
      for (int row = begin; row < end; row += Rows::kCount) {
        const auto i = static_cast<std::size_t>(row);
        update(cells.row(row), free.take<Rows>(i), occupied.take<Rows>(i));
      }
      free.leave();
      occupied.leave();
    }
  }
  return any;
}

// The rows of a tile in a plane, and no longer marked there; null where they are empty.
Footprint::Word* Footprint::marked(std::vector<Word>& plane, std::vector<std::uint8_t>& marks,
                                   std::size_t tile) {
  return std::exchange(marks[tile], std::uint8_t{0}) != 0 ? &plane[tile * kSide] : nullptr;
}

}  // namespace portolan
