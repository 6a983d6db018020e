// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/lidar.hpp"

#include <cmath>

namespace portolan::sim {

Lidar::Lidar(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

OrganizedCloud Lidar::sense(const World& world, const Pose& T_map_sensor) {
  const double ring_step =
      options_.rings > 1 ? (options_.highest - options_.lowest) / (options_.rings - 1) : 0.0;
  const double column_step = 2.0 * M_PI / options_.columns;
  const auto direction_of = [&](int ring, int column) {
    const double elevation = options_.lowest + ring * ring_step;
    const double azimuth = column * column_step - M_PI;
    return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  };
  return measure_all(options_.rings, options_.columns, direction_of, world, T_map_sensor,
                     options_.noise, random_);
}

}  // namespace portolan::sim
