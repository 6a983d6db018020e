// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/options.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/velocity.hpp"
#include "portolan/sim/world.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

/// A round robot with a differential drive that cannot pass through what stands in its way.
class Robot {
 public:
  struct Options {
    double radius = 0.2;
    double height = 0.4;
    double max_speed = 0.6;
    double max_turn_rate = 1.2;
    double max_acceleration = 1.0;
    double max_turn_acceleration = 4.0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("radius", self.radius, "of its round body [m]", above(0.0));
      visit("height", self.height, "of its body; what hangs higher does not stop it [m]",
            above(0.0));
      visit("max_speed", self.max_speed, "[m/s]", above(0.0));
      visit("max_turn_rate", self.max_turn_rate, "[rad/s]", above(0.0));
      visit("max_acceleration", self.max_acceleration, "[m/s^2]", above(0.0));
      visit("max_turn_acceleration", self.max_turn_acceleration, "[rad/s^2]", above(0.0));
    }
  };

  Robot(const Options& options, const Pose& T_map_base);

  /// Drives for a while towards the wanted velocity, within its limits. Where it would run into
  /// something it stands still instead, and turns no further.
  void advance(Duration duration, const Velocity& wanted, const World& world);

  /// Its base on the floor, x forward.
  const Pose& T_map_base() const { return T_map_base_; }
  const Velocity& velocity() const { return velocity_; }
  /// True where the last step was stopped by an obstacle.
  bool blocked() const { return blocked_; }

 private:
  Options options_;
  Pose T_map_base_;
  Velocity velocity_;
  bool blocked_ = false;
};

/// Where a base comes to that keeps its velocity: along an arc of a circle, or straight [m].
Pose driven(const Velocity& velocity, double duration);

}  // namespace portolan::sim
