// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/edge_plane.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "portolan/grid/tile_map.hpp"

namespace portolan {
namespace {

constexpr int kTiles = 5;
constexpr int kSide = kTiles * TileMap::kSide;

struct Plane {
  std::vector<std::uint64_t> words = std::vector<std::uint64_t>(kTiles * kSide);
  std::vector<std::uint8_t> marks = std::vector<std::uint8_t>(kTiles * kTiles);
  EdgePlane edges{words.data(), marks.data(), kSide};
};

TEST(EdgePlane, TogglesEdgesOfAnyLengthRowByRow) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> anywhere(0, (kSide - 1) * FinePoint::kCell);
  std::uniform_int_distribution<std::int32_t> beside(0, 100 * FinePoint::kCell);
  for (int round = 0; round < 500; ++round) {
    const FinePoint a{anywhere(random), anywhere(random)};
    FinePoint b{anywhere(random), anywhere(random)};
    if (round % 2 == 0) b.x = std::min(a.x + beside(random), (kSide - 1) * FinePoint::kCell);
    Plane plane, expected;
    plane.edges.toggle(a, b);
    fine_walk::walk_rows(a, b, EdgePlane::kOffset,
                         [&](int row, int column) { expected.edges.toggle_from(column, row); });
    ASSERT_EQ(plane.words, expected.words) << "round " << round;
    ASSERT_EQ(plane.marks, expected.marks) << "round " << round;
  }
}

}  // namespace
}  // namespace portolan
