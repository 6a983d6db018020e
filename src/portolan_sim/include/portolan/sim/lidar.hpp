// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/sim/organized_cloud.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A laser that turns about the vertical with several rings of beams.
class Lidar {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    int rings = 16;
    int columns = 900;
    double lowest = -0.2618;
    double highest = 0.2618;

    Options() {
      frame = "lidar";
      topic = "cloud_in";
      position = {0.0, 0.0, 0.6};
      noise.range_max = 30.0;
      noise.range_min = 0.4;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("rings", self.rings, "beams above each other", within(1, 1024));
      visit("columns", self.columns, "directions all round", within(1, 100000));
      visit("lowest", self.lowest, "elevation of the lowest ring [rad]", within(-1.57, 1.57));
      visit("highest", self.highest, "elevation of the highest ring [rad]", within(-1.57, 1.57));
    }
  };

  Lidar(const Options& options, std::uint64_t seed);

  /// One turn, all at once; rows are rings, the lowest first.
  OrganizedCloud sense(const World& world, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

 private:
  Options options_;
  Random random_;
};

}  // namespace portolan::sim
