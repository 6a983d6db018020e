// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "portolan/beacon/beacon_file.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {

/// What the laws need to know of BeaconMapper: planar and spatial, both parametrizations, some
/// ranges wrong and some malformed.
class BeaconMapperCase {
 public:
  using Mapper = BeaconMapper;

  explicit BeaconMapperCase(std::uint32_t seed) : random_(seed) {
    options_.space = static_cast<BeaconSpace>(seed % 2);
    options_.parametrization = static_cast<BeaconParametrization>(seed / 2 % 2);
    options_.max_beacons = 3;
    options_.max_modes = 300;
  }

  const BeaconOptions& options() const { return options_; }

  BeaconRanges observation() {
    BeaconRanges z;
    for (BeaconId id = 0; id < 4; ++id) {
      const double range = uniform(-0.5, 8.0);
      if (uniform(0.0, 1.0) < 0.7) z.ranges.push_back({id, range, uniform(0.0, 0.3)});
    }
    return z;
  }

  Pose pose() {
    Pose pose = planar_pose(uniform(-3.0, 3.0), uniform(-3.0, 3.0), uniform(-M_PI, M_PI));
    pose.translation().z() = uniform(-1.0, 1.0);
    return pose;
  }

  /// All but the number of malformed ranges: what is unusable altogether enters no log.
  static bool equal(const BeaconMapper& a, const BeaconMapper& b) {
    return to_yaml(a) == to_yaml(b) && a.counts().taken == b.counts().taken &&
           a.counts().refused == b.counts().refused;
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }

  std::mt19937 random_;
  BeaconOptions options_;
};

}  // namespace portolan
