// SPDX-License-Identifier: BSD-3-Clause
#include "grid/reference_grid.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {
namespace {

using SeenCells = std::map<std::pair<int, int>, bool>;  // whether occupied

double logit(double p) { return std::log(p / (1.0 - p)); }

// Occupied wins over free.
void mark(const ReferenceRegion& region, ReferenceRegion::Point anchor, SeenCells& seen) {
  const auto [min, max] = region.box();
  for (auto y = ((min.y + anchor.y) >> 10) - 1; y <= ((max.y + anchor.y) >> 10) + 1; ++y) {
    for (auto x = ((min.x + anchor.x) >> 10) - 1; x <= ((max.x + anchor.x) >> 10) + 1; ++x) {
      if (!region.contains({x * 1024 - anchor.x, y * 1024 - anchor.y})) continue;
      seen[{static_cast<int>(x), static_cast<int>(y)}] |= region.occupied;
    }
  }
}

}  // namespace

void ReferenceGrid::insert(const GridMapper::Observation& z, const Pose& T_map_sensor) {
  const ReferenceView view(options_, T_map_sensor, z);
  SeenCells seen;
  for (const ReferenceRegion& region : view.regions()) mark(region, view.anchor(), seen);
  for (const auto& [cell, occupied] : seen) {
    change(static_cast<GridLayer>(z.index()), cell, occupied);
  }
}

std::optional<double> ReferenceGrid::probability(GridLayer layer, Cell cell) const {
  const auto found = cells_.find({static_cast<int>(layer), {cell.x, cell.y}});
  if (found == cells_.end()) return std::nullopt;
  return 1.0 - 1.0 / (1.0 + std::exp(options_.quantum * found->second));  // Eq. 8
}

const InverseSensorModel& ReferenceGrid::model(GridLayer layer) const {
  if (layer == GridLayer::laser) return options_.laser;
  if (layer == GridLayer::sonar) return options_.sonar;
  return options_.cloud;
}

// Eq. 7 in whole quanta: l_t = l_{t-1} + tau - l_0, kept between p_min and p_max.
void ReferenceGrid::change(GridLayer layer, std::pair<int, int> cell, bool occupied) {
  const double q = options_.quantum;
  const int low = static_cast<int>(logit(options_.p_min) / q);
  const int high = static_cast<int>(logit(options_.p_max) / q);
  const int l_0 = std::clamp(static_cast<int>(std::lround(logit(options_.prior) / q)), low, high);
  const double tau = logit(occupied ? model(layer).p_occupied : model(layer).p_free);
  int step = static_cast<int>(std::lround(tau / q - l_0));
  if (step == 0) step = occupied ? 1 : -1;
  int& l = cells_.try_emplace({static_cast<int>(layer), cell}, l_0).first->second;
  l = std::clamp(l + step, low, high);
}

}  // namespace portolan
