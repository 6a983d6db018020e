// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "portolan/options.hpp"

namespace portolan {

/// Deviations of sightings that state none, and what repeats in all.
struct SightingNoiseOptions {
  double range_stddev = 0.05;
  double range_stddev_per_metre = 0.02;
  double azimuth_stddev = 0.01;
  double elevation_stddev = 0.01;
  double pixel_stddev = 1.0;
  double repeated_stddev = 0.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("range_stddev", self.range_stddev, "of ranges near by [m]", above(0.0));
    visit("range_stddev_per_metre", self.range_stddev_per_metre,
          "and so much more each metre [m/m]", at_least(0.0));
    visit("azimuth_stddev", self.azimuth_stddev, "[rad]", above(0.0));
    visit("elevation_stddev", self.elevation_stddev, "[rad]", above(0.0));
    visit("pixel_stddev", self.pixel_stddev, "of image features, along each axis [pixel]",
          above(0.0));
    visit("repeated_stddev", self.repeated_stddev,
          "of what all sightings of a landmark have wrong alike, along each axis: it does not "
          "average out, and is added to the covariance once [m]",
          at_least(0.0));
  }
};

/// What is believed of landmarks before anything says so.
struct UnmeasuredOptions {
  double min_depth = 0.4;
  double max_depth = 100.0;
  double linearity = 0.1;
  double height_stddev = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_depth", self.min_depth, "d0: nearest landmark where no range is measured [m]",
          above(0.0));
    visit("max_depth", self.max_depth, "d1: furthest one; beyond, a mere direction [m]",
          above(0.0));
    visit.require(self.min_depth < self.max_depth, "min_depth must be below max_depth");
    visit("linearity", self.linearity,
          "Civera's index below which a ray becomes a point; smaller: later", above(0.0));
    visit("height_stddev", self.height_stddev,
          "of landmarks about the plane of a sensor that measures no elevation [m]", above(0.0));
  }
};

/// How wrong sightings are told from right ones.
struct WrongSightingOptions {
  double gate = 0.999;
  double huber = 1.5;
  std::size_t restart_after = 10;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("gate", self.gate, "P(a right sighting passes the chi-squared gate)", between(0.5, 1.0));
    visit("huber", self.huber,
          "sightings further off than so many deviations count less the further (Huber)",
          above(0.0));
    visit("restart_after", self.restart_after,
          "so many in a row that agree on another place move an identified landmark there",
          at_least(2.0));
  }
};

}  // namespace portolan
