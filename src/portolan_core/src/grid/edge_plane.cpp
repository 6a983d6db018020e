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

// Toggles a few rows at a time, strip by strip where the edge crosses from one to others.
template <class Rows>
void toggle_rows(const EdgePlane plane, const Walk walk) {
  using Words = typename Rows::Words;
  constexpr int kStrip = kPlaces + 6;
  Words places{};  // of the rows, counted from the first one of the walk
  for (int i = 0; i < Rows::kCount; ++i) places[i] = static_cast<std::uint64_t>(i);
  const int first = walk.row & -Rows::kCount;
  const auto step = static_cast<std::uint64_t>(walk.step);
  places -= static_cast<std::uint64_t>(walk.row - first);
  Words x = places * step + static_cast<std::uint64_t>(walk.position);
  std::int64_t enters = walk.position;
  for (int row = first; row < walk.end; row += Rows::kCount) {
    const std::int64_t leaves = walk.at(std::min(row + Rows::kCount, walk.end) - 1);
    const Words is_crossed = places < static_cast<std::uint64_t>(walk.end - walk.row);
    const Words bits = (~Words{} << ((x >> kPlaces) & 63)) & is_crossed;
    const auto toggle = [plane, row](std::int64_t strip, Words by) {
      const std::ptrdiff_t word = strip * plane.rows + row;
      store(load<Words>(plane.words + word) ^ by, plane.words + word);
      plane.marks[word >> 6] = 1;
    };
    const auto [low, high] = std::minmax({enters >> kStrip, leaves >> kStrip});
    if (low == high) {
      toggle(low, bits);
    } else {
      for (std::int64_t strip = low; strip <= high; ++strip) {
        toggle(strip, bits & (x >> kStrip == static_cast<std::uint64_t>(strip)));
      }
    }
    enters = leaves + walk.step;
    places += std::uint64_t{Rows::kCount};
    x += step * Rows::kCount;
  }
}

}  // namespace

void EdgePlane::toggle_long(FinePoint a, FinePoint b) const {
  const Walk walk(a, b, kOffset);
  with_widest_rows([&](auto by) {
    using Rows = decltype(by);
    toggle_rows<Rows>(*this, walk);
  });
}

}  // namespace portolan
