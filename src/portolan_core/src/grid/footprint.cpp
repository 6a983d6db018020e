// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;
constexpr int kMaxSide = 8500;  // of a window [cell]: keeps the walks exact

// The lowest n bits, for n in [0, 64].
std::uint64_t ones(int n) { return n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1; }

// The columns from begin on and before end, as bits of a strip.
std::uint64_t bits(int begin, int end, int strip) {
  begin = std::clamp(begin - strip * kSide, 0, kSide);
  end = std::clamp(end - strip * kSide, begin, kSide);
  return ones(end) & ~ones(begin);
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
  spans_.assign(static_cast<std::size_t>(end_row_ - first_row_), Span{});
  for (std::size_t i = 0; i < 3; ++i) {
    fine_walk::walk_rows(corners[i], corners[(i + 1) % 3], 0.5 - fine_walk::kNudge,
                         [this](int row, int column) {
                           if (row < first_row_ || row >= end_row_) return;
                           Span& span = spans_[static_cast<std::size_t>(row - first_row_)];
                           span = {std::min(span.begin, column), std::max(span.end, column)};
                         });
  }
  measure_disc(free, free_half_);
  measure_disc(std::max(free, occupied), half_);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (half_[i] < 0 || spans_[i].begin >= spans_[i].end) continue;
    mark_row(first_row_ + static_cast<int>(i), within(spans_[i], corners[0].x, free_half_[i]),
             within(spans_[i], corners[0].x, half_[i]));
  }
  for (int strip = 0; strip < strips_; ++strip) {
    for (int row = first_row_ & ~(kSide - 1); row < end_row_; row += kSide) {
      is_free_[tile_at(strip * kSide, row)] = 1;
      is_occupied_[tile_at(strip * kSide, row)] = 1;
    }
  }
}

// Frees the free columns of a row, and occupies what all of them have besides.
void Footprint::mark_row(int row, const Span& free, const Span& all) {
  const int last = std::min((all.end - 1) >> 6, strips_ - 1);
  for (int strip = std::max(all.begin >> 6, 0); strip <= last; ++strip) {
    const Word freed = bits(free.begin, free.end, strip);
    word(free_, strip * kSide, row) |= freed;
    word(occupied_, strip * kSide, row) |= bits(all.begin, all.end, strip) & ~freed;
  }
}

// Half the width of a disc about the anchor in each covered row; negative where it does not reach.
void Footprint::measure_disc(std::int64_t radius, std::vector<std::int32_t>& half) const {
  const auto square = static_cast<double>(radius * radius - 1);  // of a distance below the radius
  constexpr int kHalf = kFine / 2;
  const double to_first = first_row_ * kFine + kHalf - in_window({0, 0}).y;
  half.resize(spans_.size());
  for (std::size_t i = 0; i < half.size(); ++i) {
    const double dy = to_first + kFine * static_cast<double>(static_cast<std::int32_t>(i));
    const double rest = square - dy * dy;
    const auto root = static_cast<std::int32_t>(std::sqrt(std::max(rest, 0.0)));
    half[i] = rest < 0.0 ? -1 : root;
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
    band_begin_ = static_cast<std::size_t>(std::max(0, first_row_ - band * kSide));
    band_end_ = static_cast<std::size_t>(std::min(kSide, end_row_ - band * kSide));
    for (std::size_t i = band_begin_; i < band_end_; ++i) carry_[i] = struck_carry_[i] = 0;
    carries_ = struck_carries_ = false;
    for (int strip = 0; strip < strips_; ++strip) {
      if (!take_bits(strip, band)) continue;
      TileMap::Tile& tile = map.at({tile_.x + strip, tile_.y + band});
      tile.revision = revision;
      is_empty = false;
      update_cells(tile, freed_, hit_, band_begin_, band_end_, update);
    }
  }
  return is_empty ? CellRect{} : covered_;
}

// Moves the bits of a tile to freed_ and hit_ and clears them here; false where there are none.
bool Footprint::take_bits(int strip, int band) {
  const std::size_t tile = tile_at(strip * kSide, band * kSide);
  const bool has_free = carries_ || is_toggled_[tile] || is_free_[tile];
  if (!has_free && !struck_carries_ && !is_struck_[tile] && !is_occupied_[tile]) return false;
  const std::size_t first =
      std::size_t(strip) * std::size_t(rows_) + std::size_t(band) * std::size_t(kSide);
  for (std::size_t i = band_begin_; i < band_end_; ++i) {
    freed_[i] = carry_[i];
    hit_[i] = struck_carry_[i];
  }
  if (std::exchange(is_toggled_[tile], std::uint8_t{0}) != 0) {
    carries_ = take_toggled(&toggled_[first], carry_, freed_);
  }
  if (std::exchange(is_struck_[tile], std::uint8_t{0}) != 0) {
    struck_carries_ = take_toggled(&struck_[first], struck_carry_, hit_);
  }
  if (std::exchange(is_free_[tile], std::uint8_t{0}) != 0) {
    for (std::size_t i = band_begin_; i < band_end_; ++i)
      freed_[i] |= std::exchange(free_[first + i], 0);
  }
  if (std::exchange(is_occupied_[tile], std::uint8_t{0}) != 0) {
    for (std::size_t i = band_begin_; i < band_end_; ++i)
      hit_[i] |= std::exchange(occupied_[first + i], 0);
  }
  return true;
}

// Adds what a plane of edges encloses to the parity left of it; true where some of it goes on.
bool Footprint::take_toggled(Word* toggled, TileBits& carry, TileBits& inside) const {
  Word any = 0;
  for (std::size_t i = band_begin_; i < band_end_; ++i) {
    inside[i] ^= toggled[i];
    carry[i] = Word{0} - (inside[i] >> 63);
    any |= carry[i];
    toggled[i] = 0;
  }
  return any != 0;
}

}  // namespace portolan
