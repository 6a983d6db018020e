// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "portolan/grid/draw.hpp"

namespace portolan {

Outcome draw(const RangeEcho& echo, const Pose& T_map_sensor, const GridOptions& options,
             EchoCone& cone) {
  if (!is_usable(echo)) return Outcome::unusable;
  if (T_map_sensor.linear().col(0).head<2>().norm() < std::cos(options.max_tilt)) {
    return Outcome::rejected;
  }
  return cone.place(echo, T_map_sensor, options) ? Outcome::inserted : Outcome::unusable;
}

}  // namespace portolan
