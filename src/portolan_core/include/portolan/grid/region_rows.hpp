// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "portolan/grid/cell_rows.hpp"

namespace portolan {

/// A region of cells on its way along a band of tiles, from left to right. What it is made of in a
/// tile comes from a plane of edges there, by the parity of all that lie left of a cell, and from a
/// plane of set bits.
class RegionRows {
 public:
  /// Goes on to the tile whose rows of the planes these are; a null is no plane.
  void enter(std::uint64_t* toggled, std::uint64_t* set) {
    toggled_ = toggled;
    set_ = set;
  }

  bool is_empty() const { return toggled_ == nullptr && set_ == nullptr && !carries_; }

  /// Takes the bits of a few rows of the tile out of the planes.
  template <class Rows>
  typename Rows::Words take(std::size_t row) {
    using Words = typename Rows::Words;
    Words inside = load<Words>(&carry_[row]);
    if (toggled_ != nullptr) {
      inside ^= taken<Words>(toggled_ + row);
      store(Words{} - (inside >> 63), &carry_[row]);
    }
    return set_ != nullptr ? inside | taken<Words>(set_ + row) : inside;
  }

  /// Leaves a tile of which all rows were taken that hold something.
  void leave() {
    if (toggled_ == nullptr) return;
    std::uint64_t any = 0;
    for (std::uint64_t parity : carry_) any |= parity;
    carries_ = any != 0;
  }

 private:
  template <class Words>
  static Words load(const std::uint64_t* from) {
    Words words;
    std::memcpy(&words, from, sizeof(words));
    return words;
  }
  template <class Words>
  static void store(Words words, std::uint64_t* to) {
    std::memcpy(to, &words, sizeof(words));
  }
  template <class Words>
  static Words taken(std::uint64_t* from) {
    const Words words = load<Words>(from);
    store(Words{}, from);
    return words;
  }

  std::uint64_t* toggled_ = nullptr;
  std::uint64_t* set_ = nullptr;
  TileBits carry_{};  // by row: all bits where the number of edges left of the tile is odd
  bool carries_ = false;
};

}  // namespace portolan
