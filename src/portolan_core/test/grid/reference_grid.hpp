// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "grid/reference_view.hpp"
#include "portolan/grid/grid_mapper.hpp"

namespace portolan {

/// The slow grid map: every cell within reach is asked, by the definitions in draw.hpp
/// and echo_cone.hpp and Eq. 7.
class ReferenceGrid {
 public:
  explicit ReferenceGrid(const GridOptions& options) : options_(options) {}

  void insert(const GridMapper::Observation& z, const Pose& T_map_sensor);

  /// P(occupied); none where nobody observed the cell.
  std::optional<double> probability(GridLayer layer, Cell cell) const;

  std::size_t size() const { return cells_.size(); }

 private:
  const InverseSensorModel& model(GridLayer layer) const;
  void change(GridLayer layer, std::pair<int, int> cell, bool occupied);

  GridOptions options_;
  std::map<std::pair<int, std::pair<int, int>>, int> cells_;  // by layer and cell: quanta
};

}  // namespace portolan
