// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/sim/material.hpp"

namespace portolan::sim {

/// A half line from a sensor into the world, in the map frame.
struct Ray {
  Eigen::Vector3d origin;     ///< [m]
  Eigen::Vector3d direction;  ///< unit vector
};

/// Where a ray met a surface.
struct Hit {
  double range;            ///< along the ray [m]
  Eigen::Vector3d normal;  ///< unit vector out of the surface
  Material material;
};

}  // namespace portolan::sim
