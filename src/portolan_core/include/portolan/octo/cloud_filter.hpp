// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/observation/point_cloud.hpp"
#include "portolan/options.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// The part of space whose points may enter a map, in a frame of choice; names of octomap_server.
struct PassThrough {
  static constexpr double kAny = 1e6;  // [m], beyond any sensor
  double min_x = -kAny;
  double max_x = kAny;
  double min_y = -kAny;
  double max_y = kAny;
  double min_z = -kAny;
  double max_z = kAny;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_x", self.min_x, "points behind this are dropped [m]");
    visit("max_x", self.max_x, "points before this are dropped [m]");
    visit("min_y", self.min_y, "points to the right of this are dropped [m]");
    visit("max_y", self.max_y, "points to the left of this are dropped [m]");
    visit("min_z", self.min_z, "points below this are dropped [m]");
    visit("max_z", self.max_z, "points above this are dropped [m]");
    visit.require(self.min_x < self.max_x && self.min_y < self.max_y && self.min_z < self.max_z,
                  "each min must be below its max");
  }
};

/// The cloud without the points outside of the box in frame f, given where the sensor is in f;
/// points that are not finite go too. No returns stay.
PointCloud pass_through(PointCloud cloud, const Pose& T_f_sensor, const PassThrough& box);

/// The cloud with at most one point, the first, in each cube of side `cell` [m] of the sensor's
/// frame, and at most one no return for each cube that they end in at `reach` [m]. Points that are
/// not finite go; nothing else moves. `cell` at or below 0 gives the cloud back as it is.
PointCloud thinned(PointCloud cloud, double cell, double reach);

}  // namespace portolan
