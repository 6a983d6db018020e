// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "portolan/observation/range_scan.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A laser that sweeps its plane.
class Laser {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    double angle_min = -3.14159265358979;
    double angle_max = 3.12413936106985;
    int beams = 360;
    double sweep_time = 0.0;

    Options() {
      frame = "laser";
      topic = "scan";
      position = {0.1, 0.0, 0.2};
      noise.range_max = 12.0;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("angle_min", self.angle_min, "of the first beam [rad]");
      visit("angle_max", self.angle_max, "of the last beam [rad]");
      visit("beams", self.beams, "in a scan", within(2, 100000));
      visit("sweep_time", self.sweep_time, "from first to last beam; 0: all at once [s]",
            within(0.0, 10.0));
      visit.require(self.angle_min != self.angle_max, "angle_min and angle_max must differ");
    }
  };

  Laser(const Options& options, std::uint64_t seed);

  /// A scan that begins at the first pose and ends at the last one. `T_first_last` is left at
  /// identity: the laser does not know how it moved.
  RangeScan sense(const World& world, const Pose& T_map_first, const Pose& T_map_last);

  const Options& options() const { return options_; }

 private:
  Options options_;
  Random random_;
};

}  // namespace portolan::sim
