// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/match/surface.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// Which echoes of a scan make a surface, and over which reach its direction is taken.
struct SurfaceOptions {
  double max_range = 30.0;
  double spacing = 0.05;
  double reach = 0.3;
  double max_gap = 1.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_range", self.max_range, "echoes from further away are not matched [m]", above(0.0));
    visit("spacing", self.spacing, "distance of the points that are matched [m]", at_least(0.0));
    visit("reach", self.reach,
          "a surface's direction is that of the echoes within this distance [m]", above(0.0));
    visit("max_gap", self.max_gap,
          "neighbouring echoes further apart than this are not of one surface [m]", above(0.0));
  }
};

/// The surfaces that a scan saw, in the frame of the sensor at its first beam; a slow sweep is
/// unwound. Empty where nothing returned or the scan is malformed.
Surface scan_surface(const RangeScan& scan, const SurfaceOptions& options);

}  // namespace portolan
