// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/sim/organized_cloud.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A camera that measures how far each of its pixels sees.
class DepthCamera {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    int width = 80;
    int height = 60;
    double field_of_view = 1.05;

    Options() {
      frame = "depth_camera_optical";
      topic = "cloud_in";
      position = {0.2, 0.0, 0.4};
      noise.range_min = 0.3;
      noise.range_max = 5.0;
      noise.range_stddev = 0.005;
      noise.stddev_per_metre = 0.005;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("width", self.width, "[pixel]", within(1, 10000));
      visit("height", self.height, "[pixel]", within(1, 10000));
      visit("field_of_view", self.field_of_view, "from left to right edge [rad]",
            between(0.0, 3.1));
    }
  };

  DepthCamera(const Options& options, std::uint64_t seed);

  /// A cloud in the optical frame (x right, y down, z forward), the top row first. Ranges, limits
  /// and noise count along the rays.
  OrganizedCloud sense(const World& world, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

 private:
  Options options_;
  Random random_;
};

}  // namespace portolan::sim
