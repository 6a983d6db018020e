// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/grid_score.hpp"

#include <stdexcept>

#include "portolan/grid/map_picture.hpp"

namespace portolan {

namespace {

bool is(const GridMapper& map, Cell cell, CellState state) { return state_of(map, cell) == state; }

bool is_occupied_nearby(const GridMapper& map, Cell cell) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (is(map, {cell.x + dx, cell.y + dy}, CellState::occupied)) return true;
    }
  }
  return false;
}

void ask(CellShare& share, bool good) {
  ++share.of;
  if (good) ++share.good;
}

}  // namespace

CellState state_of(const GridMapper& map, Cell cell) {
  const std::optional<double> p = map.probability(cell);
  if (!p) return CellState::unknown;
  if (*p > MapPicture::kOccupiedThresh) return CellState::occupied;
  return *p < MapPicture::kFreeThresh ? CellState::free : CellState::unknown;
}

GridScore score(const GridMapper& map, const GridMapper& truth, const GridMapper& view) {
  if (map.options().resolution != truth.options().resolution ||
      map.options().resolution != view.options().resolution) {
    throw std::invalid_argument("maps of different resolutions can't be compared");
  }
  GridScore score;
  const CellRect all = united(map.bounds(), view.bounds());
  for (int y = all.min.y; y < all.max.y; ++y) {
    for (int x = all.min.x; x < all.max.x; ++x) {
      const Cell cell{x, y};
      const CellState seen = state_of(map, cell);
      const CellState in_view = state_of(view, cell);
      if (seen == CellState::occupied) {
        ask(score.occupied_precision, is_occupied_nearby(truth, cell));
      }
      if (seen == CellState::free) ask(score.free_precision, is(truth, cell, CellState::free));
      if (in_view == CellState::occupied) {
        ask(score.occupied_recall, is_occupied_nearby(map, cell));
      }
      if (in_view == CellState::free) ask(score.free_recall, seen == CellState::free);
    }
  }
  return score;
}

}  // namespace portolan
