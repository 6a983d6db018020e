// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace portolan {

/// How a rectified camera draws: u = fx x / z + cx, v = fy y / z + cy, with x right, y down and
/// z forward.
struct PinholeCamera {
  double fx = 0.0;  ///< [pixel]
  double fy = 0.0;  ///< [pixel]
  double cx = 0.0;  ///< column of the optical axis; the centre of the left column is 0 [pixel]
  double cy = 0.0;  ///< row of the optical axis; the centre of the top row is 0 [pixel]
};

/// True where all is finite and both focal lengths are above 0.
inline bool is_usable(const PinholeCamera& camera) {
  return std::isfinite(camera.fx) && std::isfinite(camera.fy) && camera.fx > 0.0 &&
         camera.fy > 0.0 && std::isfinite(camera.cx) && std::isfinite(camera.cy);
}

}  // namespace portolan
