// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/beacon_receiver.hpp"

#include <cmath>
#include <string>

namespace portolan::sim {

BeaconReceiver::BeaconReceiver(const Options& options, std::uint64_t seed)
    : options_(checked(options)), seed_(seed), random_(seed, options.frame) {}

/// Adds the measured range, unless it drops out.
void BeaconReceiver::listen(std::uint32_t id, double distance, BeaconRanges& z) {
  Random own(seed_, options_.frame + "/bias/" + std::to_string(id));
  const double bias = options_.bias + own.normal(0.0, options_.bias_stddev);
  const double range = options_.noise.measure(distance + bias, random_);
  if (!std::isfinite(range)) return;
  z.ranges.push_back({id, range, options_.state_stddev ? options_.noise.stddev(distance) : 0.0});
}

BeaconRanges BeaconReceiver::sense(const World& world, const Pose& T_map_sensor) {
  BeaconRanges z;
  const std::size_t whose_turn = world.beacons().empty() ? 0 : turn_++ % world.beacons().size();
  std::size_t place = 0;
  for (const auto& [id, p_map] : world.beacons()) {
    if (options_.one_at_a_time && place++ != whose_turn) continue;
    const Eigen::Vector3d p_antenna = T_map_sensor.translation();
    if ((p_map - p_antenna).norm() > options_.noise.range_max) continue;
    if (options_.line_of_sight && !world.sees(p_antenna, p_map)) continue;
    listen(static_cast<std::uint32_t>(id), (p_map - p_antenna).norm(), z);
  }
  return z;
}

}  // namespace portolan::sim
