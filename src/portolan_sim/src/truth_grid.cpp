// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/truth_grid.hpp"

#include <Eigen/Geometry>
#include <cstddef>

namespace portolan::sim {

namespace {

constexpr int kMargin = 2;  // cells around the outermost obstacle

/// An empty grid over all obstacles, nothing known yet.
TruthGrid blank(const World& world, double resolution, const Eigen::Vector2d& start) {
  Eigen::AlignedBox2d area(start);
  for (const Obstacle& obstacle : world.obstacles()) {
    area.extend(Eigen::Vector2d(obstacle.center - half_extent(obstacle)));
    area.extend(Eigen::Vector2d(obstacle.center + half_extent(obstacle)));
  }
  constexpr double kRounding = 1e-6;  // a wall that ends on a border does not ask for another cell
  const Eigen::Array2d low = (area.min() / resolution).array() + kRounding;
  const Eigen::Array2d high = (area.max() / resolution).array() - kRounding;
  const Eigen::Array2i first = low.floor().cast<int>() - kMargin;
  const Eigen::Array2i size = high.ceil().cast<int>() + kMargin - first;
  TruthGrid grid;
  grid.resolution = resolution;
  grid.origin = first.cast<double>() * resolution;
  grid.width = size.x();
  grid.height = size.y();
  grid.cells.assign(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()),
                    TruthGrid::Cell::unknown);
  return grid;
}

void draw(const Obstacle& obstacle, TruthGrid& grid) {
  const Eigen::Vector2d half = half_extent(obstacle);
  const Eigen::Vector2i low = grid.cell_of(obstacle.center - half) - Eigen::Vector2i::Ones();
  const Eigen::Vector2i high = grid.cell_of(obstacle.center + half) + Eigen::Vector2i::Ones();
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      if (!grid.contains({column, row})) continue;
      if (overlaps(obstacle, grid.center(column, row), 0.5 * grid.resolution)) {
        grid.at({column, row}) = TruthGrid::Cell::occupied;
      }
    }
  }
}

/// Frees every cell that can be walked to from `start` over edges of cells.
void flood(const Eigen::Vector2i& start, TruthGrid& grid) {
  std::vector<Eigen::Vector2i> open = {start};
  while (!open.empty()) {
    const Eigen::Vector2i cell = open.back();
    open.pop_back();
    if (!grid.contains(cell) || grid.at(cell) != TruthGrid::Cell::unknown) continue;
    grid.at(cell) = TruthGrid::Cell::free;
    for (const Eigen::Vector2i& side : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                        Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
      open.emplace_back(cell + side);
    }
  }
}

std::uint8_t gray(TruthGrid::Cell cell) {
  switch (cell) {
    case TruthGrid::Cell::free:
      return MapPicture::kFree;
    case TruthGrid::Cell::occupied:
      return MapPicture::kOccupied;
    default:
      return MapPicture::kUnknown;
  }
}

char letter(TruthGrid::Cell cell) {
  switch (cell) {
    case TruthGrid::Cell::free:
      return '.';
    case TruthGrid::Cell::occupied:
      return '#';
    default:
      return ' ';
  }
}

}  // namespace

Eigen::Vector2i TruthGrid::cell_of(const Eigen::Vector2d& p_map) const {
  return ((p_map - origin) / resolution).array().floor().cast<int>();
}

Eigen::Vector2d TruthGrid::center(int column, int row) const {
  return origin + resolution * Eigen::Vector2d(column + 0.5, row + 0.5);
}

bool TruthGrid::contains(const Eigen::Vector2i& cell) const {
  return cell.x() >= 0 && cell.x() < width && cell.y() >= 0 && cell.y() < height;
}

TruthGrid::Cell& TruthGrid::at(const Eigen::Vector2i& cell) {
  return cells[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(cell.x())];
}

TruthGrid::Cell TruthGrid::at(const Eigen::Vector2i& cell) const {
  return cells[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(cell.x())];
}

TruthGrid truth_grid(const World& world, double resolution, double z,
                     const Eigen::Vector2d& start) {
  TruthGrid grid = blank(world, resolution, start);
  for (const Obstacle& obstacle : world.obstacles()) {
    if (obstacle.bottom <= z && z <= obstacle.top) draw(obstacle, grid);
  }
  flood(grid.cell_of(start), grid);
  return grid;
}

MapPicture to_picture(const TruthGrid& grid) {
  MapPicture picture;
  picture.resolution = grid.resolution;
  const Eigen::Array2i first = (grid.origin / grid.resolution).array().round().cast<int>();
  picture.rect = {{first.x(), first.y()}, {first.x() + grid.width, first.y() + grid.height}};
  picture.pixels.reserve(grid.cells.size());
  for (const TruthGrid::Cell cell : grid.cells) picture.pixels.push_back(gray(cell));
  return picture;
}

std::string to_text(const TruthGrid& grid) {
  std::string text;
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width; ++column) text += letter(grid.at({column, row}));
    text += '\n';
  }
  return text;
}

}  // namespace portolan::sim
