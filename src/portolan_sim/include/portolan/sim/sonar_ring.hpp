// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "portolan/observation/range_echo.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/range_noise.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// Sonars on a circle, all looking outwards.
class SonarRing {
 public:
  struct Options : SensorOptions {
    RangeNoise noise;
    std::vector<double> angles = {-1.5708, -1.1220, -0.6732, -0.2244,
                                  0.2244,  0.6732,  1.1220,  1.5708};
    double radius = 0.2;
    double aperture = 0.44;
    double specular_angle = 0.6;
    double crosstalk = 0.0;
    int rays = 15;
    bool in_turn = false;

    Options() {
      frame = "sonar";
      topic = "sonar";
      rate = 5.0;
      position = {0.0, 0.0, 0.2};
      noise.range_max = 4.0;
      noise.range_stddev = 0.02;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      RangeNoise::describe(self.noise, visit);
      visit("angles", self.angles,
            "of the sonars on the ring; each has the frame <frame>_<place "
            "in this list> [rad]");
      visit("radius", self.radius, "of the ring [m]", at_least(0.0));
      visit("aperture", self.aperture, "full angle of each cone [rad]", between(0.0, 3.1));
      visit("specular_angle", self.specular_angle,
            "a surface that is met further from its normal throws the sound away; above pi/2: "
            "none does [rad]",
            above(0.0));
      visit("crosstalk", self.crosstalk, "P(the echo heard is that of another sonar)",
            within(0.0, 1.0));
      visit("rays", self.rays, "across the cone", within(1, 1001));
      visit("in_turn", self.in_turn, "one sonar after the other, as if one turned; else together");
      visit.require(!self.angles.empty(), "angles must name a sonar");
    }
  };

  SonarRing(const Options& options, std::uint64_t seed);

  std::size_t size() const { return options_.angles.size(); }
  /// The frame of one sonar.
  std::string frame(std::size_t sonar) const;
  /// Its place on the base: on the circle, x outwards.
  Pose mount(std::size_t sonar) const;

  /// What one sonar hears, the base being there.
  RangeEcho sense(std::size_t sonar, const World& world, const Pose& T_map_base);

  /// The distance to the nearest surface in the cone that throws sound back; infinity where none
  /// does up to the sensor's reach [m].
  double nearest(std::size_t sonar, const World& world, const Pose& T_map_base) const;

  /// The rays of a cone in the sonar's frame, unit vectors.
  const std::vector<Eigen::Vector3d>& cone() const { return cone_; }
  const Options& options() const { return options_; }

 private:
  Options options_;
  Random random_;
  std::vector<Eigen::Vector3d> cone_;
};

}  // namespace portolan::sim
