// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "portolan/landmark/landmark_choices.hpp"
#include "portolan/landmark/landmark_sensor_options.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How sightings without identity become landmarks.
struct LandmarkIdentityOptions {
  StatedIdentities stated = StatedIdentities::used;
  LandmarkMatching matching = LandmarkMatching::nearest;
  double birth_gate = 8.0;
  double merge_gate = 0.5;
  double apart = 0.05;
  double reach = 30.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("stated", self.stated, "what becomes of the identities that sightings state");
    visit("matching", self.matching, "how those without are assigned to landmarks");
    visit("birth_gate", self.birth_gate,
          "one that is nearer than so many deviations to a landmark, though it does not pass the "
          "gate, starts no other",
          at_least(0.0));
    visit("merge_gate", self.merge_gate,
          "P(two estimates of one landmark are further apart than where they are merged)",
          between(0.0, 1.0));
    visit("apart", self.apart, "nearer landmarks are one, whatever their deviations [m]",
          at_least(0.0));
    visit("reach", self.reach,
          "landmarks further from the sensor are neither missed nor taken for what is seen without "
          "range [m]",
          above(0.0));
  }
};

/// When a landmark is believed in.
struct LandmarkExistenceOptions {
  std::size_t sightings = 5;
  std::size_t identified_sightings = 1;
  double p_spurious = 0.3;
  double forget_below = 0.05;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("sightings", self.sightings, "that make a landmark without identity", at_least(1.0));
    visit("identified_sightings", self.identified_sightings, "that make one with identity",
          at_least(1.0));
    visit("p_spurious", self.p_spurious,
          "P(a sighting falls on a place where another did | no landmark is there)",
          between(0.0, 1.0));
    visit("forget_below", self.forget_below,
          "existence probability below which a landmark without identity that should be seen and "
          "is not is forgotten; 0: never",
          within(0.0, 0.4));
  }
};

/// How well sensor poses are known, where that matters.
struct LandmarkPoseOptions {
  double position_stddev = 0.0;
  double heading_stddev = 0.0;
  StatedCovariance stated = StatedCovariance::ignored;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("position_stddev", self.position_stddev, "along each axis [m]", at_least(0.0));
    visit("heading_stddev", self.heading_stddev, "[rad]", at_least(0.0));
    visit("stated", self.stated,
          "what becomes of the covariance in the messages on odom_topic, which comes on top; zeros "
          "say that it is unknown");
  }
};

/// How a `LandmarkMapper` works; the mapper calls it `Options`.
struct LandmarkOptions {
  LandmarkSpace space = LandmarkSpace::automatic;
  LandmarkFilter filter = LandmarkFilter::ekf;
  LoadedLandmarks loaded = LoadedLandmarks::prior;
  std::size_t max_landmarks = 1000000;
  SightingNoiseOptions noise;
  UnmeasuredOptions unmeasured;
  WrongSightingOptions wrong;
  LandmarkIdentityOptions identity;
  LandmarkExistenceOptions existence;
  LandmarkPoseOptions pose;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("space", self.space, "where landmarks may be");
    visit("filter", self.filter, "how a landmark takes in a further sighting");
    visit("loaded", self.loaded, "what becomes of landmarks from a file");
    visit("max_landmarks", self.max_landmarks, "sightings of further ones are dropped",
          at_least(1.0));
    visit("noise", self.noise, "deviations of sightings that state none, and what repeats in all");
    visit("unmeasured", self.unmeasured, "depth and height until they are measured");
    visit("wrong", self.wrong, "wrong sightings");
    visit("identity", self.identity, "sightings without identity");
    visit("existence", self.existence, "when a landmark is believed in");
    visit("pose", self.pose,
          "deviations of the sensor's pose, taken to be independent from message to message; "
          "landmarks are over-confident where poses err and this is 0");
  }
};

}  // namespace portolan
