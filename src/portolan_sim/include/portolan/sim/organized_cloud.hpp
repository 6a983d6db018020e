// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/observation/point_cloud.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A cloud in rows and columns. A place without return holds infinity along its ray, and its
/// direction stands among the cloud's `no_returns`.
struct OrganizedCloud {
  PointCloud cloud;
  std::uint32_t width = 0;   ///< columns
  std::uint32_t height = 0;  ///< rows, one after the other in `cloud.points`
};

/// Measures along the ray of the cloud's next place, a unit vector in the sensor's frame. What is
/// too close leaves infinity against the ray, a failed reading NaN.
void measure_next(const Eigen::Vector3d& direction, const World& world, const Pose& T_map_sensor,
                  const RangeNoise& noise, Random& random, OrganizedCloud& organized);

/// Measures along `rows` by `columns` rays; direction_of(row, column) is a unit vector in the
/// sensor's frame.
template <class DirectionOf>
OrganizedCloud measure_all(int rows, int columns, DirectionOf direction_of, const World& world,
                           const Pose& T_map_sensor, const RangeNoise& noise, Random& random) {
  OrganizedCloud organized;
  organized.width = static_cast<std::uint32_t>(columns);
  organized.height = static_cast<std::uint32_t>(rows);
  organized.cloud.points.reserve(std::size_t{organized.width} * organized.height);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      measure_next(direction_of(row, column), world, T_map_sensor, noise, random, organized);
    }
  }
  return organized;
}

}  // namespace portolan::sim
