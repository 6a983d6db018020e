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
  auto scans = std::make_shared<std::vector<GridMapper::Observation>>();
  for (const Workload::PosedScan& posed : workload.scans) scans->emplace_back(posed.scan);
  Drawer drawer;
  drawer.scan = [map, scans, &workload](std::size_t i) {
    map->insert((*scans)[i], workload.scans[i].T_map_sensor);
  };
  drawer.echo = [map](const RangeEcho& echo) { map->insert(echo, Pose::Identity()); };
  return drawer;
}

}  // namespace portolan::bench
