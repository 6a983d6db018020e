// SPDX-License-Identifier: BSD-3-Clause
#include "graph/elimination_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace portolan {
namespace {

using Edges = std::vector<std::pair<int, int>>;

// Four crossings, each joined to every other by a street of that many nodes.
constexpr int kCrossings = 4;
Edges streets(int length) {
  Edges edges;
  int next = kCrossings;
  for (int a = 0; a < kCrossings; ++a) {
    for (int b = a + 1; b < kCrossings; ++b) {
      int last = a;
      for (int i = 0; i < length; ++i, last = next++) edges.emplace_back(last, next);
      edges.emplace_back(last, b);
    }
  }
  return edges;
}

TEST(EliminationOrder, takes_streets_before_crossings_and_along_them) {
  const int length = 10;
  const int size = kCrossings + 6 * length;
  const std::vector<int> order = elimination_order(Neighbours(size, streets(length)));
  for (int crossing = 0; crossing < kCrossings; ++crossing) {
    EXPECT_GE(order[static_cast<std::size_t>(crossing)], 6 * length);
  }
  for (std::size_t i = kCrossings; i + 1 < static_cast<std::size_t>(size); ++i) {
    const bool is_last = (static_cast<int>(i) - kCrossings) % length == length - 1;
    EXPECT_TRUE(is_last || order[i] < order[i + 1]) << i;
  }
}

TEST(EliminationOrder, has_a_place_for_every_node) {
  std::mt19937_64 random(3);
  for (int size = 1; size < 60; ++size) {
    std::uniform_int_distribution<int> any(0, size - 1);
    Edges edges;
    for (int i = 0; i < 2 * size; ++i) {
      const int a = any(random);
      const int b = any(random);
      if (a != b) edges.emplace_back(a, b);
    }
    std::vector<int> order = elimination_order(Neighbours(size, edges));
    std::sort(order.begin(), order.end());
    for (int i = 0; i < size; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i) << size;
  }
}

}  // namespace
}  // namespace portolan
