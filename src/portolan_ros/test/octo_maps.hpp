// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "portolan/octo/octo_mapper.hpp"

namespace portolan {

inline OctoMapper::Options octo_options() {
  OctoMapper::Options options;
  options.resolution = 0.1;
  return options;
}

/// A cloud all around, the same for the same seed.
inline PointCloud octo_cloud(unsigned seed, std::size_t points = 200) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<float>(random() % 4001) * 1e-3F - 2.0F; };
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    cloud.points.emplace_back(x, y, coordinate());
  }
  return cloud;
}

inline OctoMapper octo_map(unsigned seed, const OctoMapper::Options& options = octo_options()) {
  OctoMapper map(options);
  for (unsigned i = 0; i < 4; ++i) {
    map.insert(octo_cloud(10 * seed + i), planar_pose(0.2 * i, 0.1, 0.3));
  }
  return map;
}

}  // namespace portolan
