// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/depth_camera.hpp"

#include <cmath>

namespace portolan::sim {

DepthCamera::DepthCamera(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

OrganizedCloud DepthCamera::sense(const World& world, const Pose& T_map_sensor) {
  const double focal_length = 0.5 * options_.width / std::tan(0.5 * options_.field_of_view);
  const auto direction_of = [&](int row, int column) {
    const double right = column - 0.5 * (options_.width - 1);
    const double down = row - 0.5 * (options_.height - 1);
    return Eigen::Vector3d(right, down, focal_length).normalized();
  };
  return measure_all(options_.height, options_.width, direction_of, world, T_map_sensor,
                     options_.noise, random_);
}

}  // namespace portolan::sim
