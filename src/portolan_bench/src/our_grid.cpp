// SPDX-License-Identifier: BSD-3-Clause
#include "our_grid.hpp"

namespace portolan::bench {

GridOptions our_options(double max_range, Margin margin) {
  GridOptions options;
  if (margin == Margin::none) options.laser.margin = 0.0;
  options.laser.max_range = max_range;
  options.sonar.max_range = max_range;
  return options;
}

Drawer our_grid(const Workload& workload, Margin margin) {
  auto map = std::make_shared<GridMapper>(our_options(workload.max_range, margin));
  return [map, &workload](std::size_t i) {
    map->insert(workload.readings[i].z, workload.readings[i].T_map_sensor);
  };
}

}  // namespace portolan::bench
