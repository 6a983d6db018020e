// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/edge_plane.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

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

TEST(TakeRows, AddsTheParityOfEdgesAndSetBits) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 64; ++round) {
    const std::size_t begin = random() % 64;
    const std::size_t end = begin + random() % (65 - begin);
    TileBits toggled{}, set{}, carry{}, bits{};
    for (std::size_t i = begin; i < end; ++i) {
      toggled[i] = random();
      set[i] = random() & random();
      carry[i] = random() % 2 ? ~std::uint64_t{0} : 0;
    }
    const bool has_edges = round % 2 == 0;
    const bool has_set = round % 4 < 2;
    const TileBits edges = has_edges ? toggled : TileBits{};
    const TileBits more = has_set ? set : TileBits{};
    const TileBits left = carry;
    const bool goes_on = take_rows(has_edges ? toggled.data() : nullptr,
                                   has_set ? set.data() : nullptr, begin, end, carry, bits);
    bool expected_on = false;
    for (std::size_t i = begin; i < end; ++i) {
      ASSERT_EQ(bits[i], (edges[i] ^ left[i]) | more[i]) << "round " << round << " row " << i;
      const bool is_odd = ((edges[i] ^ left[i]) >> 63) != 0;
      ASSERT_EQ(carry[i], is_odd ? ~std::uint64_t{0} : 0) << "round " << round << " row " << i;
      expected_on = expected_on || is_odd;
    }
    EXPECT_EQ(goes_on, expected_on);
    if (has_edges) {
      EXPECT_EQ(toggled, TileBits{});
    }
    if (has_set) {
      EXPECT_EQ(set, TileBits{});
    }
  }
}

}  // namespace
}  // namespace portolan
