// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/observation/point_cloud.hpp"

namespace portolan::sim {

/// A cloud in rows and columns; a place without return holds NaN, and its direction stands among
/// the cloud's `no_returns`.
struct OrganizedCloud {
  PointCloud cloud;
  std::uint32_t width = 0;   ///< columns
  std::uint32_t height = 0;  ///< rows, one after the other in `cloud.points`
};

/// Adds the next place of the cloud: a unit vector in the sensor's frame and what was measured
/// along it, infinity for nothing [m]. Too close (-infinity) leaves NaN and says nothing more.
void append(OrganizedCloud& organized, const Eigen::Vector3d& direction, double range);

}  // namespace portolan::sim
