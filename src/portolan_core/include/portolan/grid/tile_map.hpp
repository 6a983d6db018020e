// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "portolan/grid/cell.hpp"
#include "portolan/grid/log_odds.hpp"

namespace portolan {

/// A grid of bytes without bounds: square tiles, made where they are first written.
class TileMap {
 public:
  static constexpr int kSide = 64;  ///< of a tile [cell]; a row of one is a cache line
  static constexpr int kSideLog2 = 6;

  struct Tile {
    alignas(64) std::array<CellByte, kSide * kSide> cells{};  // row by row
    Cell index;                                               // which tile: cell / kSide
    std::uint64_t revision = 0;                               // of the map when last written

    CellByte* row(int y) { return &cells[static_cast<std::size_t>(y) * kSide]; }
    const CellByte* row(int y) const { return &cells[static_cast<std::size_t>(y) * kSide]; }
    CellRect rect() const {
      return {{index.x * kSide, index.y * kSide}, {(index.x + 1) * kSide, (index.y + 1) * kSide}};
    }
  };

  /// The tile, made if it was not there. Its address holds as long as the map does.
  Tile& at(Cell tile_index);

  /// The tile, or null where nothing was written.
  const Tile* find(Cell tile_index) const;

  /// The byte of a cell; kNeverObserved where nothing was written.
  CellByte cell(Cell c) const;

  /// Every tile, in the order in which they were made.
  const std::deque<Tile>& tiles() const { return tiles_; }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Slot {
    Cell index;
    std::uint32_t tile = kNone;
  };

  std::size_t slot_of(Cell tile_index) const;
  void grow();

  std::deque<Tile> tiles_;
  std::vector<Slot> slots_ = std::vector<Slot>(64);  // open addressing, at most half full
};

/// What it occupies in memory [byte].
std::size_t byte_size(const TileMap& map);

}  // namespace portolan
