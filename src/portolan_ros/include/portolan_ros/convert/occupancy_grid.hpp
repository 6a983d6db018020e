// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <optional>

#include "portolan/grid/grid_mapper.hpp"

namespace portolan::ros_convert {

/// One layer, or all of them fused.
using GridSheet = std::optional<GridLayer>;

/// The rectangle that a sheet has observed, out to whole blocks of 64 cells, so that it grows in
/// few steps. Empty where nothing was observed.
CellRect published_rect(const GridMapper& map, GridSheet sheet);

/// A rectangle of cells as a map: P(occupied) in percent, -1 unknown. Header: left to the caller.
nav_msgs::OccupancyGrid occupancy_grid(const GridMapper& map, GridSheet sheet,
                                       const CellRect& rect);

/// What changed of a map that was published with `rect`. Header: left to the caller.
map_msgs::OccupancyGridUpdate occupancy_grid_update(const GridMapper& map, GridSheet sheet,
                                                    const CellRect& rect, const CellRect& changed);

}  // namespace portolan::ros_convert
