// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/lidar.hpp"

#include <cmath>
#include <limits>

namespace portolan::sim {

Lidar::Lidar(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

OrganizedCloud Lidar::sense(const World& world, const Pose& T_map_sensor) {
  OrganizedCloud organized;
  organized.width = static_cast<std::uint32_t>(options_.columns);
  organized.height = static_cast<std::uint32_t>(options_.rings);
  organized.cloud.points.reserve(std::size_t{organized.width} * organized.height);
  const double ring_step =
      options_.rings > 1 ? (options_.highest - options_.lowest) / (options_.rings - 1) : 0.0;
  const double column_step = 2.0 * M_PI / options_.columns;
  for (int ring = 0; ring < options_.rings; ++ring) {
    const double elevation = options_.lowest + ring * ring_step;
    for (int column = 0; column < options_.columns; ++column) {
      const double azimuth = column * column_step - M_PI;
      const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      const Ray ray{T_map_sensor.translation(), T_map_sensor.linear() * direction};
      const std::optional<Hit> hit = world.cast(ray, Wave::light, options_.noise.range_max);
      const double range = hit ? hit->range : std::numeric_limits<double>::infinity();
      append(organized, direction, options_.noise.measure(range, random_));
    }
  }
  return organized;
}

}  // namespace portolan::sim
