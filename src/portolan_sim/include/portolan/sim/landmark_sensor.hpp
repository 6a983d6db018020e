// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/observation/landmark_sightings.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// Finds landmarks and says how far they are, in which direction, and perhaps which.
class LandmarkSensor {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    double azimuth_stddev = 0.01;
    double elevation_stddev = 0.01;
    double horizontal_view = 6.28318530717959;
    double vertical_view = 1.6;
    bool identities = true;
    bool bearing_only = false;
    bool planar = false;
    bool state_stddev = true;
    double false_positives = 0.0;

    Options() {
      frame = "landmark_sensor";
      topic = "landmark_sightings";
      position = {0.0, 0.0, 0.5};
      noise.range_min = 0.2;
      noise.range_max = 6.0;
      noise.range_stddev = 0.05;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("azimuth_stddev", self.azimuth_stddev, "[rad]", at_least(0.0));
      visit("elevation_stddev", self.elevation_stddev, "[rad]", at_least(0.0));
      visit("horizontal_view", self.horizontal_view, "full angle about x [rad]",
            above_to(0.0, 6.3));
      visit("vertical_view", self.vertical_view, "full angle about x [rad]", above_to(0.0, 3.2));
      visit("identities", self.identities, "says which landmark it is");
      visit("bearing_only", self.bearing_only, "says no range");
      visit("planar", self.planar, "says no elevation; its range is that in its xy plane");
      visit("state_stddev", self.state_stddev, "states its deviations; else 0, unknown");
      visit("false_positives", self.false_positives,
            "landmarks seen where none is, on average in "
            "a measurement",
            within(0.0, 100.0));
    }
  };

  LandmarkSensor(const Options& options, std::uint64_t seed);

  /// Every landmark in reach, in view and not hidden.
  LandmarkSightings sense(const World& world, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

 private:
  void imagine(const World& world, LandmarkSightings& z);
  void sight(std::int32_t id, double range, double azimuth, double elevation, LandmarkSightings& z);

  Options options_;
  Random random_;
};

}  // namespace portolan::sim
