// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "portolan/grid/grid_mapper.hpp"

namespace portolan {

/// A share of cells: how many of those that were asked about are as they should be.
struct CellShare {
  std::size_t good = 0;
  std::size_t of = 0;

  /// In [0, 1]; NaN where none was asked about.
  double value() const { return static_cast<double>(good) / static_cast<double>(of); }
};

/// How well a grid map agrees with the truth.
struct GridScore {
  CellShare occupied_precision;  ///< occupied in the map: in truth too, within one cell
  CellShare occupied_recall;     ///< surfaces in view: occupied in the map, within one cell
  CellShare free_precision;      ///< free in the map: in truth too
  CellShare free_recall;         ///< free and in view: free in the map too
};

/// What a map says of a cell, as map_server divides it.
enum class CellState { unknown, free, occupied };

constexpr std::array<const char*, 3> enum_names(CellState) {
  return {"unknown", "free", "occupied"};
}

/// Free below P = 0.196, occupied above 0.65, unknown else and where nobody observed it.
CellState state_of(const GridMapper& map, Cell cell);

/// Compares a map with the truth and with the part of it that could be seen. All three must have
/// the same resolution and frame. Throws std::invalid_argument where resolutions differ.
GridScore score(const GridMapper& map, const GridMapper& truth, const GridMapper& view);

}  // namespace portolan
