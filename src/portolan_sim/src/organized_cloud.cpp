// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/organized_cloud.hpp"

#include <cmath>
#include <limits>

namespace portolan::sim {

void measure_next(const Eigen::Vector3d& direction, const World& world, const Pose& T_map_sensor,
                  const RangeNoise& noise, Random& random, OrganizedCloud& organized) {
  const Ray ray{T_map_sensor.translation(), T_map_sensor.linear() * direction};
  const std::optional<Hit> hit = world.cast(ray, Wave::light, noise.range_max);
  const double range =
      noise.measure(hit ? hit->range : std::numeric_limits<double>::infinity(), random);
  organized.cloud.points.emplace_back((range * direction).cast<float>());
  if (std::isinf(range) && range > 0.0) {
    organized.cloud.no_returns.emplace_back(direction.cast<float>());
  }
}

}  // namespace portolan::sim
