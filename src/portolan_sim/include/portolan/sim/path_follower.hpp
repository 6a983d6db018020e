// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "portolan/options.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/velocity.hpp"

namespace portolan::sim {

/// Steers from point to point, straight lines between them: turns towards the next point, drives.
class PathFollower {
 public:
  struct Options {
    double speed = 0.5;
    double turn_rate = 1.0;
    double tolerance = 0.05;
    double sharp_turn = 0.2;
    double spin_at_points = 0.0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("speed", self.speed, "along the path [m/s]", above(0.0));
      visit("turn_rate", self.turn_rate, "at most [rad/s]", above(0.0));
      visit("tolerance", self.tolerance, "a point is reached within this [m]", above(0.0));
      visit("sharp_turn", self.sharp_turn, "stops to turn where the point is further aside [rad]",
            above_to(0.0, 3.1));
      visit("spin_at_points", self.spin_at_points, "turns so far about itself at each point [rad]");
    }
  };

  PathFollower(const Options& options, std::vector<Eigen::Vector2d> points);

  /// What to drive now to get on. Call it once per step, with the true pose.
  Velocity steer(const Pose& T_map_base, double duration);

  bool finished() const { return next_ == points_.size() && left_to_spin_ <= 0.0; }

 private:
  Velocity spin(double duration);
  Velocity approach(const Eigen::Vector2d& to_point, double heading) const;

  Options options_;
  std::vector<Eigen::Vector2d> points_;
  std::size_t next_ = 0;
  double left_to_spin_ = 0.0;  // [rad]
};

}  // namespace portolan::sim
