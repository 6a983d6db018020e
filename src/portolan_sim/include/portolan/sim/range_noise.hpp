// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/options.hpp"
#include "portolan/sim/random.hpp"

namespace portolan::sim {

/// How a range sensor errs: a little always, now and then altogether.
struct RangeNoise {
  double range_min = 0.05;
  double range_max = 10.0;
  double range_stddev = 0.01;
  double stddev_per_metre = 0.0;
  double dropout = 0.0;
  double outliers = 0.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("range_min", self.range_min, "nearer things are not seen [m]", at_least(0.0));
    visit("range_max", self.range_max, "farther things are not seen [m]", above(0.0));
    visit("range_stddev", self.range_stddev, "deviation of a range [m]", at_least(0.0));
    visit("stddev_per_metre", self.stddev_per_metre, "more deviation per range [m/m]",
          at_least(0.0));
    visit("dropout", self.dropout, "P(nothing returns, whatever is there)", within(0.0, 1.0));
    visit("outliers", self.outliers, "P(range is any, with nothing there)", within(0.0, 1.0));
    visit.require(self.range_min < self.range_max, "range_min must be below range_max");
  }

  /// One sigma at this range [m].
  double stddev(double range) const { return range_stddev + stddev_per_metre * range; }

  /// What the sensor says where the truth is `range` [m], infinity where nothing returns: a range
  /// between the limits, -infinity for too close, +infinity for nothing (REP 117).
  double measure(double range, Random& random) const;
};

}  // namespace portolan::sim
