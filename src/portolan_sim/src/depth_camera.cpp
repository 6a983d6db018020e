// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/depth_camera.hpp"

#include <cmath>
#include <limits>

namespace portolan::sim {

DepthCamera::DepthCamera(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

OrganizedCloud DepthCamera::sense(const World& world, const Pose& T_map_sensor) {
  OrganizedCloud organized;
  organized.width = static_cast<std::uint32_t>(options_.width);
  organized.height = static_cast<std::uint32_t>(options_.height);
  organized.cloud.points.reserve(std::size_t{organized.width} * organized.height);
  const double focal_length = 0.5 * options_.width / std::tan(0.5 * options_.field_of_view);
  for (int row = 0; row < options_.height; ++row) {
    for (int column = 0; column < options_.width; ++column) {
      const double right = column - 0.5 * (options_.width - 1);
      const double down = row - 0.5 * (options_.height - 1);
      const Eigen::Vector3d direction = Eigen::Vector3d(right, down, focal_length).normalized();
      const Ray ray{T_map_sensor.translation(), T_map_sensor.linear() * direction};
      const std::optional<Hit> hit = world.cast(ray, Wave::light, options_.noise.range_max);
      const double range = hit ? hit->range : std::numeric_limits<double>::infinity();
      append(organized, direction, options_.noise.measure(range, random_));
    }
  }
  return organized;
}

}  // namespace portolan::sim
