// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "portolan/options.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/random.hpp"

namespace portolan::sim {

/// Wheel odometry: adds up the robot's motions, each with an error, and so drifts away.
///
/// A motion is a turn, a straight line and a turn (Thrun, Burgard and Fox, Probabilistic Robotics,
/// section 5.4). The variance of each part grows in proportion to the motion, not to its square,
/// so that the drift over a way does not depend on how often odometry is read.
class Odometry {
 public:
  struct Options {
    double alpha1 = 0.0005;
    double alpha2 = 0.00005;
    double alpha3 = 0.0005;
    double alpha4 = 0.00005;
    double distance_scale = 1.0;
    double turn_scale = 1.0;
    double turn_per_metre = 0.0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("alpha1", self.alpha1, "variance of turning per turn [rad^2/rad]", at_least(0.0));
      visit("alpha2", self.alpha2, "variance of turning per distance [rad^2/m]", at_least(0.0));
      visit("alpha3", self.alpha3, "variance of distance per distance [m^2/m]", at_least(0.0));
      visit("alpha4", self.alpha4, "variance of distance per turn [m^2/rad]", at_least(0.0));
      visit("distance_scale", self.distance_scale, "distances are read this much longer",
            above(0.0));
      visit("turn_scale", self.turn_scale, "turns are read this much larger", above(0.0));
      visit("turn_per_metre", self.turn_per_metre, "turns that are read but not made [rad/m]");
    }
  };

  /// Begins at `T_odom_base`.
  Odometry(const Options& options, std::uint64_t seed, const Pose& T_odom_base = Pose::Identity());

  /// Tells it where the base truly is now; the first time is where it begins.
  void update(const Pose& T_map_base);

  /// Where it believes the base is.
  const Pose& T_odom_base() const { return T_odom_base_; }

  /// Covariance of x, y [m] and heading [rad] of T_odom_base in the odometry frame, to first order.
  /// Systematic drift is none of it.
  const Eigen::Matrix3d& covariance() const { return covariance_; }

 private:
  Options options_;
  Random random_;
  bool started_ = false;
  Pose T_map_base_ = Pose::Identity();
  Pose T_odom_base_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
};

}  // namespace portolan::sim
