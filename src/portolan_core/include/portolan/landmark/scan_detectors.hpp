// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/observation/landmark_sightings.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// What all detectors of landmarks in a scan need to know.
struct ScanDetectorOptions {
  double max_range = 30.0;
  double gap = 0.3;
  double range_stddev = 0.02;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_range", self.max_range, "nothing is looked for beyond [m]", above(0.0));
    visit("gap", self.gap, "echoes further apart belong to different things [m]", above(0.0));
    visit("range_stddev", self.range_stddev, "deviation of one echo [m]", above(0.0));
  }
};

/// Marks that throw back more light than anything else.
struct ReflectorOptions {
  double min_intensity = 1000.0;
  double max_width = 0.3;
  double radius = 0.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_intensity", self.min_intensity, "of their echoes, in the scanner's own unit");
    visit("max_width", self.max_width, "wider ones are something else [m]", above(0.0));
    visit("radius", self.radius, "of round ones, from their face to their axis [m]", at_least(0.0));
  }
};

/// Round things that stand alone: poles, trunks, pillars.
struct PoleOptions {
  double min_radius = 0.03;
  double max_radius = 0.4;
  std::size_t min_echoes = 4;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_radius", self.min_radius, "[m]", above(0.0));
    visit("max_radius", self.max_radius, "[m]", above(0.0));
    visit.require(self.min_radius < self.max_radius, "min_radius must be below max_radius");
    visit("min_echoes", self.min_echoes, "on one of them", at_least(3.0));
  }
};

/// Where two straight walls meet.
struct CornerOptions {
  double min_length = 0.4;
  std::size_t min_echoes = 6;
  double min_angle = 0.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_length", self.min_length, "of each wall [m]", above(0.0));
    visit("min_echoes", self.min_echoes, "on each wall", at_least(3.0));
    visit("min_angle", self.min_angle, "between the walls, and from straight on [rad]",
          between(0.0, 1.57));
  }
};

/// Planar sightings without identity, seen from where the scan began, with deviations.
/// `intensities` are those of the scan's echoes; none are found where their numbers differ.
LandmarkSightings detect_reflectors(const RangeScan& scan, const std::vector<float>& intensities,
                                    const ScanDetectorOptions& detector,
                                    const ReflectorOptions& options);

LandmarkSightings detect_poles(const RangeScan& scan, const ScanDetectorOptions& detector,
                               const PoleOptions& options);

LandmarkSightings detect_corners(const RangeScan& scan, const ScanDetectorOptions& detector,
                                 const CornerOptions& options);

}  // namespace portolan
