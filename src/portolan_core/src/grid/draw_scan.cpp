// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "portolan/grid/draw.hpp"

namespace portolan {

namespace {

bool is_tilted(const Pose& T_map_sensor, const GridOptions& options) {
  return std::abs(T_map_sensor(2, 2)) < std::cos(options.max_tilt);
}

}  // namespace

Outcome draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
             ScanFan& fan, Footprint& footprint) {
  if (!is_usable(scan)) return Outcome::unusable;
  if (is_tilted(T_map_sensor, options) || is_tilted(T_map_sensor * scan.T_first_last, options)) {
    return Outcome::rejected;
  }
  return fan.draw(scan, T_map_sensor, options, footprint) ? Outcome::inserted : Outcome::unusable;
}

}  // namespace portolan
