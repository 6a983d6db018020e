// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "portolan/observation/limits.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// Where beacons may be.
enum class BeaconSpace {
  planar,   ///< in the plane of the map, or at a known height above the antenna
  spatial,  ///< anywhere
};

constexpr std::array<const char*, 2> enum_names(BeaconSpace) { return {"planar", "spatial"}; }

/// In which coordinates a newly heard beacon is estimated.
enum class BeaconParametrization {
  cartesian_mixture,  ///< a ring of Gaussians in x, y, z, each with an EKF
  polar,  ///< a few Gaussians in distance and direction, each with a UKF, split on demand
};

constexpr std::array<const char*, 2> enum_names(BeaconParametrization) {
  return {"cartesian_mixture", "polar"};
}

/// How often and how far ranges are wrong: reflections, paths round a corner, interference.
struct RangeOutlierOptions {
  double share = 0.05;
  double late_share = 0.5;
  double late_mean = 2.0;
  double max_range = 200.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("share", self.share, "P(a range is wrong)", between(0.0, 1.0));
    visit("late_share", self.late_share,
          "P(a wrong range is too long because the signal took a detour); the rest are anywhere",
          within(0.0, 1.0));
    visit("late_mean", self.late_mean, "mean length of that detour [m]", above(0.0));
    visit("max_range", self.max_range, "longer ranges are dropped [m]",
          above_to(0.0, kFurthestReading));
  }
};

/// What may be wrong with all ranges: reading = scale * distance + bias, from poses that turn too
/// far.
struct RangeCalibrationOptions {
  double scale = 1.0;
  double scale_stddev = 0.03;
  double bias = 0.0;
  double bias_stddev = 0.1;
  double turn_stddev = 0.0005;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("scale", self.scale, "reading per distance, as far as is known", above(0.0));
    visit("scale_stddev", self.scale_stddev, "how uncertain that is; 0: not estimated",
          at_least(0.0));
    visit("bias", self.bias, "reading at distance 0, as far as is known [m]");
    visit("bias_stddev", self.bias_stddev, "how uncertain that is; 0: not estimated [m]",
          at_least(0.0));
    visit("turn_stddev", self.turn_stddev,
          "by how much poses may turn too far per way travelled; 0: not estimated [rad/m]",
          at_least(0.0));
  }
};

/// When a beacon is given up and started anew: it was moved, or its first range was wrong.
struct BeaconRestartOptions {
  bool enabled = true;
  double fit_below = 0.25;
  double memory = 40.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("enabled", self.enabled, "start beacons anew that no longer fit their ranges");
    visit("fit_below", self.fit_below, "share of recent ranges that fit, below which to restart",
          within(0.0, 1.0));
    visit("memory", self.memory, "how many ranges are recent", at_least(8.0));
  }
};

/// How a `BeaconMapper` works; the mapper calls it `Options`.
struct BeaconOptions {
  BeaconSpace space = BeaconSpace::planar;
  BeaconParametrization parametrization = BeaconParametrization::cartesian_mixture;
  double stddev = 0.3;
  double drift = 0.05;
  bool learn_drift = true;
  bool learn_noise = true;
  double height = 0.0;
  double elevation_min = -1.5707963267948966;
  double elevation_max = 1.5707963267948966;
  std::size_t max_beacons = 256;
  std::size_t max_modes = 2000;
  double prune_below = 1e-4;
  double merge_distance = 1.0;
  double ambiguous_share = 0.1;
  RangeOutlierOptions outliers;
  RangeCalibrationOptions calibration;
  BeaconRestartOptions restart;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("space", self.space, "where beacons may be");
    visit("parametrization", self.parametrization, "how a new beacon is estimated");
    visit("stddev", self.stddev, "of ranges that state none [m]", above(0.0));
    visit("drift", self.drift, "how far poses drift per root of the way travelled [m/sqrt(m)]",
          at_least(0.0));
    visit("learn_drift", self.learn_drift,
          "take that as a first guess and learn it from the ranges, up to half as much again; off "
          "for poses known exactly");
    visit("learn_noise", self.learn_noise,
          "believe that ranges spread wider than they state where they do");
    visit("height", self.height, "of the beacons above the antenna, where the space is planar [m]");
    visit("elevation_min", self.elevation_min,
          "of beacons seen from the antenna, where the space is spatial [rad]",
          within(-1.5707963267948966, 1.5707963267948966));
    visit("elevation_max", self.elevation_max,
          "of beacons seen from the antenna, where the space is spatial [rad]",
          within(-1.5707963267948966, 1.5707963267948966));
    visit.require(self.elevation_min < self.elevation_max,
                  "elevation_min must be below elevation_max");
    visit("max_beacons", self.max_beacons, "ranges to further ones are dropped", at_least(1.0));
    visit("max_modes", self.max_modes, "of one beacon; the lightest go", at_least(8.0));
    visit("prune_below", self.prune_below, "a mode lighter than this share of the heaviest goes",
          between(0.0, 1.0));
    visit("merge_distance", self.merge_distance,
          "modes closer than this Mahalanobis distance become one; in a crowd, 0.6 of it; 2.5 "
          "times as far where ranges are linear",
          within(0.0, 3.0));
    visit("ambiguous_share", self.ambiguous_share,
          "a beacon is ambiguous while modes elsewhere hold more than this weight",
          between(0.0, 1.0));
    visit("outliers", self.outliers, "wrong ranges");
    visit("calibration", self.calibration, "scale, bias and turn shared by all beacons");
    visit("restart", self.restart, "giving up a beacon's place");
  }
};

}  // namespace portolan
