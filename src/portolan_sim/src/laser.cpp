// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/laser.hpp"

#include <cmath>
#include <limits>

namespace portolan::sim {

namespace {

double angle_increment(const Laser::Options& options) {
  return (options.angle_max - options.angle_min) / (options.beams - 1);
}

}  // namespace

Laser::Laser(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

RangeScan Laser::sense(const World& world, const Pose& T_map_first, const Pose& T_map_last) {
  RangeScan scan;
  scan.angle_min = options_.angle_min;
  scan.angle_increment = angle_increment(options_);
  scan.range_min = options_.noise.range_min;
  scan.range_max = options_.noise.range_max;
  scan.ranges.reserve(static_cast<std::size_t>(options_.beams));
  const bool sweeps = options_.sweep_time > 0.0;
  for (int i = 0; i < options_.beams; ++i) {
    const double angle = scan.angle_min + i * scan.angle_increment;
    const Pose T_map_beam =
        sweeps ? interpolate(T_map_first, T_map_last, static_cast<double>(i) / (options_.beams - 1))
               : T_map_first;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    const Ray ray{T_map_beam.translation(), T_map_beam.linear() * direction};
    const std::optional<Hit> hit = world.cast(ray, Wave::light, options_.noise.range_max);
    const double range = hit ? hit->range : std::numeric_limits<double>::infinity();
    scan.ranges.push_back(static_cast<float>(options_.noise.measure(range, random_)));
  }
  return scan;
}

}  // namespace portolan::sim
