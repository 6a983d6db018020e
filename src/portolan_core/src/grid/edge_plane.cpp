// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/edge_plane.hpp"

#include <algorithm>
#include <cstring>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

using fine_walk::kPlaces;
using fine_walk::Walk;

template <class Words>
Words load(const std::uint64_t* from) {
  Words words;
  std::memcpy(&words, from, sizeof(words));
  return words;
}

template <class Words>
void store(Words words, std::uint64_t* to) {
  std::memcpy(to, &words, sizeof(words));
}

// Reads words and clears them.
template <class Words>
Words take(std::uint64_t* from) {
  const Words words = load<Words>(from);
  store(Words{}, from);
  return words;
}

void toggle_one_by_one(const EdgePlane& plane, const Walk& walk, int begin, int end) {
  for (int row = begin; row < end; ++row) {
    plane.toggle_from(static_cast<int>(walk.at(row) >> kPlaces), row);
  }
}

// Toggles the rows [begin, end) of those from `row` on, where the edge stays within a strip.
template <class Rows>
void toggle_in_strip(const EdgePlane& plane, const Walk& walk, int row, int begin, int end,
                     std::int64_t strip) {
  using Words = typename Rows::Words;
  Words places;
  for (int i = 0; i < Rows::kCount; ++i) places[i] = static_cast<std::uint64_t>(i);
  const Words x =
      places * static_cast<std::uint64_t>(walk.step) + static_cast<std::uint64_t>(walk.at(row));
  const Words bits = ~Words{} << ((x >> kPlaces) & 63);
  const auto first = static_cast<std::uint64_t>(begin - row);
  const auto count = static_cast<std::uint64_t>(end - begin);
  const std::ptrdiff_t word = strip * plane.rows + row;
  std::uint64_t* words = plane.words + word;
  store(load<Words>(words) ^ (places - first < count ? bits : Words{}), words);
  plane.marks[word >> 6] = 1;
}

// An edge that is not flat mostly stays that long within a strip.
template <class Rows>
void toggle_rows(const EdgePlane& plane, const Walk& walk) {
  for (int row = walk.row & -Rows::kCount; row < walk.end; row += Rows::kCount) {
    const int begin = std::max(row, walk.row);
    const int end = std::min(row + Rows::kCount, walk.end);
    const std::int64_t strip = walk.at(begin) >> (kPlaces + 6);
    if (strip == walk.at(end - 1) >> (kPlaces + 6)) {
      toggle_in_strip<Rows>(plane, walk, row, begin, end, strip);
    } else {
      toggle_one_by_one(plane, walk, begin, end);
    }
  }
}

template <class Rows>
bool take_rows(std::uint64_t* toggled, std::uint64_t* set, std::size_t begin, std::size_t end,
               TileBits& carry, TileBits& bits) {
  using Words = typename Rows::Words;
  constexpr std::size_t kCount = Rows::kCount;
  Words odd{};
  for (std::size_t i = begin & ~(kCount - 1); i < end; i += kCount) {
    Words inside = load<Words>(&carry[i]);
    if (toggled) {
      inside ^= take<Words>(toggled + i);
      store(Words{} - (inside >> 63), &carry[i]);
    }
    odd |= inside;
    store(set ? inside | take<Words>(set + i) : inside, &bits[i]);
  }
  std::uint64_t any = 0;
  for (int i = 0; i < Rows::kCount; ++i) any |= odd[i];
  return any >> 63 != 0;
}

}  // namespace

void EdgePlane::toggle_long(FinePoint a, FinePoint b) const {
  const Walk walk(a, b, kOffset);
  with_widest_rows([&](auto by) {
    using Rows = decltype(by);
    if (Rows::kCount > 2) {
      toggle_rows<Rows>(*this, walk);
    } else {
      toggle_one_by_one(*this, walk, walk.row, walk.end);
    }
  });
}

bool take_rows(std::uint64_t* toggled, std::uint64_t* set, std::size_t begin, std::size_t end,
               TileBits& carry, TileBits& bits) {
  return with_widest_rows(
      [&](auto by) { return take_rows<decltype(by)>(toggled, set, begin, end, carry, bits); });
}

}  // namespace portolan
