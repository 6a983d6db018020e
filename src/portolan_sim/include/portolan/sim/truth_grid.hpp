// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "portolan/grid/map_picture.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// The map that a perfect mapper would draw: which squares of the floor are free or occupied.
struct TruthGrid {
  enum class Cell : std::uint8_t { free, occupied, unknown };

  double resolution = 0.05;                          ///< side of a cell [m]
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< lower left corner [m]
  int width = 0;                                     ///< in cells
  int height = 0;                                    ///< in cells
  std::vector<Cell> cells;                           ///< row by row, from the lowest y

  /// The cell that holds the point; may lie outside the grid.
  Eigen::Vector2i cell_of(const Eigen::Vector2d& p_map) const;
  /// The middle of a cell [m].
  Eigen::Vector2d center(int column, int row) const;
  bool contains(const Eigen::Vector2i& cell) const;
  Cell& at(const Eigen::Vector2i& cell);
  Cell at(const Eigen::Vector2i& cell) const;
};

/// The world cut at height `z` [m], with corners at multiples of the resolution [m] and a margin
/// of two cells. A cell is occupied where an obstacle reaches into it, free where one can get to
/// it from `start`, and unknown else: the inside of solids and whatever is shut off.
TruthGrid truth_grid(const World& world, double resolution, double z, const Eigen::Vector2d& start);

/// As map_server's files hold it: 254 free, 0 occupied, 205 unknown.
MapPicture to_picture(const TruthGrid& grid);

/// Drawn in text, top row first: '.' free, '#' occupied, ' ' unknown.
std::string to_text(const TruthGrid& grid);

}  // namespace portolan::sim
