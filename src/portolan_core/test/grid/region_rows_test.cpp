// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/region_rows.hpp"

#include <gtest/gtest.h>

#include <random>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {
namespace {

constexpr std::size_t kTiles = 6;

struct Tile {
  bool has_edges = false;
  bool has_set = false;
  TileBits toggled{};
  TileBits set{};
};

// Words of a few rows of a tile, and none in the rest; of some tiles none at all.
std::array<Tile, kTiles> random_band(std::mt19937_64& random) {
  const std::size_t begin = random() % TileMap::kSide;
  std::array<Tile, kTiles> band;
  for (Tile& tile : band) {
    tile.has_edges = random() % 2 == 0;
    tile.has_set = random() % 2 == 0;
    for (std::size_t i = begin; i < TileMap::kSide; ++i) {
      if (tile.has_edges) tile.toggled[i] = random();
      if (tile.has_set) tile.set[i] = random() & random();
    }
  }
  return band;
}

TEST(RegionRows, AddTheParityOfEdgesAndSetBits) {
  std::mt19937_64 random(1);
  std::size_t empty = 0;
  for (int round = 0; round < 64; ++round) {
    std::array<Tile, kTiles> band = random_band(random);
    RegionRows rows;
    TileBits odd{};
    for (Tile& tile : band) {
      const Tile before = tile;
      rows.enter(tile.has_edges ? tile.toggled.data() : nullptr,
                 tile.has_set ? tile.set.data() : nullptr);
      TileBits bits{};
      for (std::size_t row = 0; row < TileMap::kSide; row += 2) {
        const TwoRows::Words words = rows.take<TwoRows>(row);
        std::memcpy(&bits[row], &words, sizeof(words));
      }
      rows.leave();
      for (std::size_t row = 0; row < TileMap::kSide; ++row) {
        const std::uint64_t inside = before.toggled[row] ^ odd[row];
        ASSERT_EQ(bits[row], inside | before.set[row]) << "round " << round << " row " << row;
        odd[row] = inside >> 63 != 0 ? ~std::uint64_t{0} : 0;
      }
      EXPECT_EQ(tile.toggled, TileBits{});
      EXPECT_EQ(tile.set, TileBits{});
      rows.enter(nullptr, nullptr);
      EXPECT_EQ(rows.is_empty(), odd == TileBits{}) << "round " << round;
      empty += rows.is_empty() ? 1 : 0;
    }
  }
  EXPECT_GT(empty, 0U);
}

}  // namespace
}  // namespace portolan
