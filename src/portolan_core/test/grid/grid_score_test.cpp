// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/grid_score.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace portolan {
namespace {

/// A map of the rows of a picture, top row first: '#' occupied, '.' free, ' ' unknown.
GridMapper drawn(const std::vector<std::string>& rows, const GridOptions& options = {}) {
  const LogOdds log_odds(options);
  GridMapper::KeptLayer layer;
  layer.rect = {{0, 0}, {static_cast<int>(rows[0].size()), static_cast<int>(rows.size())}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      layer.cells.push_back(c == '#' ? log_odds.max() : c == '.' ? log_odds.min() : kNeverObserved);
    }
  }
  return GridMapper(options, {layer});
}

TEST(GridScore, IsPerfectForTheTruthItself) {
  const GridMapper truth = drawn({"####", "#..#", "####"});
  const GridScore perfect = score(truth, truth, truth);
  EXPECT_EQ(perfect.occupied_precision.value(), 1.0);
  EXPECT_EQ(perfect.occupied_recall.value(), 1.0);
  EXPECT_EQ(perfect.free_precision.value(), 1.0);
  EXPECT_EQ(perfect.free_recall.value(), 1.0);
  EXPECT_EQ(perfect.free_recall.of, 2u);
}

TEST(GridScore, ForgivesOccupiedCellsOneCellAndFreeOnesNone) {
  const GridMapper truth = drawn({".....#", ".....#"});
  const GridMapper map = drawn({"#...#.", "....#."});
  const GridScore found = score(map, truth, truth);
  EXPECT_EQ(found.occupied_precision.good, 2u);  // those beside the wall; not the one far away
  EXPECT_EQ(found.occupied_precision.of, 3u);
  EXPECT_EQ(found.occupied_recall.value(), 1.0);
  EXPECT_EQ(found.free_precision.good, 7u);  // not those on the wall
  EXPECT_EQ(found.free_precision.of, 9u);
  EXPECT_EQ(found.free_recall.good, 7u);
  EXPECT_EQ(found.free_recall.of, 10u);
}

TEST(GridScore, AsksOnlyForWhatWasInView) {
  const GridMapper truth = drawn({"#....#"});
  const GridMapper view = drawn({"#..   "});
  const GridMapper map = drawn({"#.    "});
  const GridScore found = score(map, truth, view);
  EXPECT_EQ(found.occupied_recall.of, 1u);
  EXPECT_EQ(found.free_recall.good, 1u);
  EXPECT_EQ(found.free_recall.of, 2u);
}

TEST(GridScore, RefusesOtherResolutions) {
  GridOptions coarse;
  coarse.resolution = 0.1;
  const GridMapper truth = drawn({"#."});
  EXPECT_THROW(score(drawn({"#."}, coarse), truth, truth), std::invalid_argument);
}

TEST(GridScore, DividesCellsAsMapServerDoes) {
  const GridMapper map = drawn({"#. "});
  EXPECT_EQ(state_of(map, {0, 0}), CellState::occupied);
  EXPECT_EQ(state_of(map, {1, 0}), CellState::free);
  EXPECT_EQ(state_of(map, {2, 0}), CellState::unknown);
  EXPECT_EQ(state_of(map, {9, 9}), CellState::unknown);
}

}  // namespace
}  // namespace portolan
