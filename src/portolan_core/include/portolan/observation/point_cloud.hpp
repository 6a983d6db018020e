// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace portolan {

/// What a depth sensor saw in one moment: the points that returned something, and the directions
/// from which nothing came back.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;      ///< in the sensor's frame [m]; may hold NaN
  std::vector<Eigen::Vector3f> no_returns;  ///< unit vectors in the sensor's frame
};

/// What it occupies in memory [byte].
inline std::size_t byte_size(const PointCloud& cloud) {
  return sizeof(cloud) +
         (cloud.points.capacity() + cloud.no_returns.capacity()) * sizeof(Eigen::Vector3f);
}

}  // namespace portolan
