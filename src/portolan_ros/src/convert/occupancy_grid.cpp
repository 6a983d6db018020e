// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/occupancy_grid.hpp"

namespace portolan::ros_convert {

namespace {

constexpr int kBlock = 64;  // [cell]

int block_down(int cell) {
  return cell >= 0 ? cell / kBlock * kBlock : -((-cell + kBlock - 1) / kBlock * kBlock);
}
int block_up(int cell) { return -block_down(-cell); }

std::vector<std::int8_t> cells(const GridMapper& map, GridSheet sheet, const CellRect& rect) {
  return sheet ? map.occupancy(*sheet, rect) : map.occupancy(rect);
}

}  // namespace

CellRect published_rect(const GridMapper& map, GridSheet sheet) {
  const CellRect seen = sheet ? map.bounds(*sheet) : map.bounds();
  if (seen.empty()) return {};
  return {{block_down(seen.min.x), block_down(seen.min.y)},
          {block_up(seen.max.x), block_up(seen.max.y)}};
}

nav_msgs::OccupancyGrid occupancy_grid(const GridMapper& map, GridSheet sheet,
                                       const CellRect& rect) {
  const double resolution = map.options().resolution;
  nav_msgs::OccupancyGrid message;
  message.info.resolution = static_cast<float>(resolution);
  message.info.width = static_cast<std::uint32_t>(rect.width());
  message.info.height = static_cast<std::uint32_t>(rect.height());
  message.info.origin.position.x = rect.min.x * resolution;
  message.info.origin.position.y = rect.min.y * resolution;
  message.info.origin.orientation.w = 1.0;
  message.data = cells(map, sheet, rect);
  return message;
}

map_msgs::OccupancyGridUpdate occupancy_grid_update(const GridMapper& map, GridSheet sheet,
                                                    const CellRect& rect, const CellRect& changed) {
  map_msgs::OccupancyGridUpdate message;
  message.x = changed.min.x - rect.min.x;
  message.y = changed.min.y - rect.min.y;
  message.width = static_cast<std::uint32_t>(changed.width());
  message.height = static_cast<std::uint32_t>(changed.height());
  message.data = cells(map, sheet, changed);
  return message;
}

}  // namespace portolan::ros_convert
