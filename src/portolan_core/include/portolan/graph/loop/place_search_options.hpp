// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/options.hpp"

namespace portolan {

/// How a robot is looked for whose place in the graph is not known.
struct PlaceSearchOptions {
  bool enabled = true;
  int places = 20;
  double spacing = 2.0;
  double reach = 2.5;
  double resolution = 0.25;
  int max_points = 80;
  double min_agreed = 0.93;
  double confirmation_way = 8.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("enabled", self.enabled,
          "look in the whole graph for a robot that was carried, or that starts in a graph that "
          "was loaded");
    visit("places", self.places, "so many places are compared at each keyframe", at_least(1));
    visit("spacing", self.spacing, "distance of places [m]", above(0.0));
    visit("reach", self.reach, "half side of the area that is searched around a place [m]",
          above(0.0));
    visit("resolution", self.resolution, "poses are tried so far from each other at first [m]",
          above(0.0));
    visit("max_points", self.max_points, "so many points are tried at first", at_least(3));
    visit("min_agreed", self.min_agreed,
          "as loops/min_agreed, where nothing else speaks for a place", within(0.0, 1.0));
    visit("confirmation_way", self.confirmation_way, "as loops/confirmation_way, likewise [m]",
          at_least(0.0));
  }
};

}  // namespace portolan
