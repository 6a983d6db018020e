// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/chain_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "portolan/grid/tile_map.hpp"

namespace portolan {
namespace {

constexpr int kTiles = 5;
constexpr int kSide = kTiles * TileMap::kSide;
constexpr FinePoint kShift{3 * FinePoint::kCell / 2, 517};

struct Plane {
  std::vector<std::uint64_t> words = std::vector<std::uint64_t>(kTiles * kSide);
  std::vector<std::uint8_t> marks = std::vector<std::uint8_t>(kTiles * kTiles);
  EdgePlane edges{words.data(), marks.data(), kSide};
};

/// A walk by steps of some cells, now and then a jump; every other one along centres and corners.
FinePoints random_chain(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const std::int32_t grain = any(random) < 0.5 ? FinePoint::kCell / 2 : 1;
  const double reach = (kSide - 3.0) * FinePoint::kCell / grain;
  const double stride = 8.0 * any(random) * FinePoint::kCell / grain;
  FinePoints chain;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i <= count; ++i) {
    const bool jumps = i == 0 || any(random) < 0.1;
    x = jumps ? reach * any(random) : std::clamp(x + stride * (any(random) - 0.5), 0.0, reach);
    y = jumps ? reach * any(random) : std::clamp(y + stride * (any(random) - 0.5), 0.0, reach);
    chain.x.push_back(grain * static_cast<std::int32_t>(x));
    chain.y.push_back(grain * static_cast<std::int32_t>(y));
  }
  return chain;
}

TEST(ChainEdges, TogglesWhatIsMarkedAsEdgesOneByOneDo) {
  std::mt19937 random(1);
  ChainEdges edges;
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 1 + random() % 100;
    const FinePoints chain = random_chain(random, count);
    std::vector<std::uint8_t> is_marked;
    for (std::size_t i = 0; i < count; ++i) {
      is_marked.push_back(static_cast<std::uint8_t>(random() % 4 != 0));
    }
    Plane plane;
    Plane expected;
    edges.toggle(chain, is_marked, kShift, plane.edges);
    for (std::size_t i = 0; i < count; ++i) {
      if (is_marked[i] == 0) continue;
      const FinePoint a = chain.at(i);
      const FinePoint b = chain.at(i + 1);
      fine_walk::walk_rows({a.x + kShift.x, a.y + kShift.y}, {b.x + kShift.x, b.y + kShift.y},
                           EdgePlane::kOffset,
                           [&](int row, int column) { expected.edges.toggle_from(column, row); });
    }
    ASSERT_EQ(plane.words, expected.words) << "round " << round;
    ASSERT_EQ(plane.marks, expected.marks) << "round " << round;
  }
}

}  // namespace
}  // namespace portolan
