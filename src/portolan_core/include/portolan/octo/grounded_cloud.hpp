// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "portolan/observation/point_cloud.hpp"

namespace portolan {

/// A point cloud of which some points were found to be the ground that the robot drives on: the
/// way to them is free, they themselves are no obstacle.
struct GroundedCloud {
  PointCloud obstacles;
  std::vector<Eigen::Vector3f> ground;  ///< in the sensor's frame [m]
};

/// What it occupies in memory [byte].
inline std::size_t byte_size(const GroundedCloud& cloud) {
  return byte_size(cloud.obstacles) + sizeof(cloud.ground) +
         cloud.ground.capacity() * sizeof(Eigen::Vector3f);
}

}  // namespace portolan
