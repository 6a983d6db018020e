// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "portolan/observation/limits.hpp"

namespace portolan {

/// How a rectified camera draws: u = fx x / z + cx, v = fy y / z + cy, with x right, y down and
/// z forward.
struct PinholeCamera {
  double fx = 0.0;  ///< [pixel]
  double fy = 0.0;  ///< [pixel]
  double cx = 0.0;  ///< column of the optical axis; the centre of the left column is 0 [pixel]
  double cy = 0.0;  ///< row of the optical axis; the centre of the top row is 0 [pixel]
};

/// True where both focal lengths are above 0, and all is a number that a camera can have.
inline bool is_usable(const PinholeCamera& camera) {
  constexpr double kLeastFocalLength = 1e-3;  // 1 where images are normalised
  const auto is_pixel = [](double value) { return std::abs(value) <= kFurthestPixel; };
  return camera.fx >= kLeastFocalLength && camera.fy >= kLeastFocalLength && is_pixel(camera.fx) &&
         is_pixel(camera.fy) && is_pixel(camera.cx) && is_pixel(camera.cy);
}

}  // namespace portolan
