// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/tile_map.hpp"

namespace portolan {

namespace {

std::size_t hash(Cell tile_index) {
  const auto x = static_cast<std::uint32_t>(tile_index.x);
  const auto y = static_cast<std::uint32_t>(tile_index.y);
  const std::uint64_t key = (static_cast<std::uint64_t>(y) << 32) | x;
  return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 32);
}

}  // namespace

std::size_t TileMap::slot_of(Cell tile_index) const {
  std::size_t slot = hash(tile_index) & (slots_.size() - 1);
  while (slots_[slot].tile != kNone && slots_[slot].index != tile_index) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slot;
}

TileMap::Tile& TileMap::at(Cell tile_index) {
  const Slot& found = slots_[slot_of(tile_index)];
  if (found.tile != kNone) return tiles_[found.tile];
  if (2 * (tiles_.size() + 1) > slots_.size()) grow();
  slots_[slot_of(tile_index)] = {tile_index, static_cast<std::uint32_t>(tiles_.size())};
  tiles_.emplace_back();
  tiles_.back().index = tile_index;
  return tiles_.back();
}

const TileMap::Tile* TileMap::find(Cell tile_index) const {
  const Slot& found = slots_[slot_of(tile_index)];
  return found.tile == kNone ? nullptr : &tiles_[found.tile];
}

CellByte TileMap::cell(Cell c) const {
  const Tile* tile = find({c.x >> kSideLog2, c.y >> kSideLog2});
  return tile ? tile->row(c.y & (kSide - 1))[c.x & (kSide - 1)] : kNeverObserved;
}

void TileMap::grow() {
  slots_.assign(2 * slots_.size(), Slot{});
  for (std::uint32_t i = 0; i < tiles_.size(); ++i)
    slots_[slot_of(tiles_[i].index)] = {tiles_[i].index, i};
}

std::size_t byte_size(const TileMap& map) {
  const std::size_t tiles = map.tiles().size();
  return sizeof(map) + tiles * (sizeof(TileMap::Tile) + 4 * sizeof(std::uint64_t) * 3);
}

}  // namespace portolan
