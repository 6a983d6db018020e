// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "portolan/grid/grid_layer.hpp"
#include "portolan/grid/inverse_sensor_model.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// The options of `GridMapper`.
struct GridOptions {
  double resolution = 0.05;
  double prior = 0.5;
  double quantum = 0.05;
  double p_min = 0.02;
  double p_max = 0.98;
  Fusion fusion = Fusion::max;
  double max_extent = 1000.0;
  double max_tilt = 0.3;
  LaserModel laser;
  SonarModel sonar;
  CloudModel cloud;

  /// Sensors reach at most so many cells: footprints of that size are still quick to draw.
  static constexpr double kMaxReach = 4000.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, "side of a cell [m]", above(0.0));
    visit("prior", self.prior, "P(cell occupied) before anything was seen", between(0.0, 1.0));
    visit("quantum", self.quantum, "log-odds of one step of the eight-bit cells", above(0.0));
    visit("p_min", self.p_min, "a cell's probability never falls below", between(0.0, 0.196));
    visit("p_max", self.p_max, "a cell's probability never rises above", between(0.65, 1.0));
    visit("fusion", self.fusion, "how the layers that observed a cell make one map");
    visit("max_extent", self.max_extent,
          "half side of the square about the origin in which sensors may stand [m]", above(0.0));
    visit("max_tilt", self.max_tilt,
          "lasers and sonars that point so far out of the horizontal are rejected [rad]",
          within(0.0, 1.2));
    visit("laser", self.laser, "how planar scans are believed");
    visit("sonar", self.sonar, "how cones are believed");
    visit("cloud", self.cloud, "how point clouds are believed");
    visit.require(self.p_min < self.prior && self.prior < self.p_max,
                  "prior must lie between p_min and p_max");
    visit.require(self.fits_in_eight_bits(),
                  "quantum must be so large that p_min and p_max are at most 127 steps from 0.5");
    visit.require(self.max_extent / self.resolution <= 1e6,
                  "max_extent must be at most a million cells");
    visit.require(self.moves_cells(self.laser) && self.moves_cells(self.sonar) &&
                      self.moves_cells(self.cloud),
                  "every p_free must lie below prior and p_occupied above it, by half a quantum "
                  "of log-odds at least");
    visit.require(std::max({self.laser.max_range, self.sonar.max_range, self.cloud.max_range}) <=
                      kMaxReach * self.resolution,
                  "every max_range must be at most 4000 cells");
    visit.require(
        self.laser.margin <= self.laser.max_range && self.sonar.margin <= self.sonar.max_range,
        "margin must be at most max_range");
  }

 private:
  static double logit(double p) { return std::log(p / (1.0 - p)); }

  bool fits_in_eight_bits() const {
    return std::max(-logit(p_min), logit(p_max)) / quantum <= 127.0;
  }

  /// True where one observation moves a cell by at least a step, and in the right direction.
  bool moves_cells(const InverseSensorModel& model) const {
    return (logit(model.p_occupied) - logit(prior)) / quantum >= 0.5 &&
           (logit(prior) - logit(model.p_free)) / quantum >= 0.5;
  }
};

}  // namespace portolan
