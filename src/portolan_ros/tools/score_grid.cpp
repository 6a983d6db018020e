// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "portolan/grid/grid_score.hpp"
#include "portolan/grid/map_files.hpp"
#include "portolan_ros/picture.hpp"
#include "portolan_ros/report.hpp"

namespace {

using portolan::Cell;
using portolan::CellRect;
using portolan::CellState;
using portolan::GridMapper;
using portolan::Picture;

GridMapper load(const std::filesystem::path& yaml) {
  return portolan::load_map(yaml.parent_path(), yaml.stem().string(), portolan::GridOptions{});
}

/// Grey where both agree, in colour where they do not: red stands in the map alone, orange in the
/// truth alone and should have been seen, blue is free in the map but solid.
Picture::Colour colour(const GridMapper& map, const GridMapper& truth, const GridMapper& view,
                       Cell cell) {
  const CellState seen = state_of(map, cell);
  const CellState real = state_of(truth, cell);
  if (seen == CellState::occupied) {
    return real == CellState::occupied ? Picture::Colour{0, 0, 0} : Picture::Colour{220, 50, 47};
  }
  if (seen == CellState::free) {
    return real == CellState::free ? Picture::Colour{254, 254, 254} : Picture::Colour{38, 139, 210};
  }
  if (state_of(view, cell) == CellState::occupied) return {240, 160, 40};
  return {205, 205, 205};
}

Picture difference(const GridMapper& map, const GridMapper& truth, const GridMapper& view) {
  const CellRect rect = united(map.bounds(), truth.bounds());
  Picture picture(static_cast<std::size_t>(rect.width()), static_cast<std::size_t>(rect.height()),
                  {205, 205, 205});
  for (int y = rect.min.y; y < rect.max.y; ++y) {
    for (int x = rect.min.x; x < rect.max.x; ++x) {
      picture.set(x - rect.min.x, rect.max.y - 1 - y, colour(map, truth, view, {x, y}));
    }
  }
  return picture.enlarged(2);
}

void print_row(const std::string& name, const portolan::GridScore& score) {
  std::printf("| %s | %.3f | %.3f | %.3f | %.3f |\n", name.c_str(),
              score.occupied_precision.value(), score.occupied_recall.value(),
              score.free_precision.value(), score.free_recall.value());
}

constexpr const char* kUsage =
    "usage: score_grid NAME MAP.yaml TRUTH.yaml VIEW.yaml OUT.png\n"
    "Compares a grid with the true one, of which VIEW is what could be seen: prints a row of a "
    "Markdown\n"
    "table (precision and recall of occupied cells, and of free ones), and draws what differs.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 5, 5, kUsage)) return *code;
  const GridMapper map = load(argv[2]);
  const GridMapper truth = load(argv[3]);
  const GridMapper view = load(argv[4]);
  print_row(argv[1], score(map, truth, view));
  const std::filesystem::path out = argv[5];
  portolan::save_files(out.parent_path(),
                       {{out.filename().string(), difference(map, truth, view).png()}});
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
