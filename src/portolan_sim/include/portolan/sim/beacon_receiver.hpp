// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "portolan/observation/beacon_ranges.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// An antenna that measures its distance to beacons, through walls if need be.
class BeaconReceiver {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    double bias = 0.0;
    double bias_stddev = 0.0;
    bool line_of_sight = false;
    bool one_at_a_time = false;
    bool state_stddev = true;

    Options() {
      frame = "antenna";
      topic = "beacon_ranges";
      rate = 5.0;
      position = {0.0, 0.0, 0.5};
      noise.range_min = 0.0;
      noise.range_max = 30.0;
      noise.range_stddev = 0.1;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("bias", self.bias, "all ranges are read this much longer [m]");
      visit("bias_stddev", self.bias_stddev,
            "each beacon adds a bias of its own; its deviation [m]", at_least(0.0));
      visit("line_of_sight", self.line_of_sight, "hears only beacons that it could see");
      visit("one_at_a_time", self.one_at_a_time, "one beacon in each message, in turn");
      visit("state_stddev", self.state_stddev, "states its deviation; else 0, unknown");
    }
  };

  BeaconReceiver(const Options& options, std::uint64_t seed);

  /// The ranges to all beacons that it heard, or to the one whose turn it is.
  BeaconRanges sense(const World& world, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

 private:
  void listen(std::uint32_t id, double distance, BeaconRanges& z);

  Options options_;
  std::uint64_t seed_;
  Random random_;
  std::size_t turn_ = 0;
};

}  // namespace portolan::sim
