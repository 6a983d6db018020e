// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "portolan/landmark/landmark_file.hpp"
#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan {

/// What the laws need to know of LandmarkMapper: ranges, bearings and images, planar and not, with
/// and without identities, some of it malformed; a small room, so that much meets.
class LandmarkMapperCase {
 public:
  using Mapper = LandmarkMapper;

  explicit LandmarkMapperCase(std::uint32_t seed) : random_(seed) {
    options_.filter = static_cast<LandmarkFilter>(seed % 2);
    options_.identity.matching = static_cast<LandmarkMatching>(seed / 2 % 2);
    options_.pose.position_stddev = seed % 3 == 0 ? 0.1 : 0.0;
    options_.pose.stated = static_cast<StatedCovariance>(seed / 4 % 2);
    options_.noise.range_stddev = 0.5;
    options_.noise.azimuth_stddev = 0.3;
    options_.noise.elevation_stddev = 0.3;
    options_.noise.pixel_stddev = 40.0;
    options_.existence.sightings = 2;
    options_.identity.birth_gate = 3.0;
    options_.max_landmarks = 20;
  }

  const LandmarkOptions& options() const { return options_; }

  LandmarkMapper::Observation observation() {
    if (chance(0.3)) return image();
    LandmarkSightings z;
    if (chance(0.5)) z.pose_covariance = uniform(0.0, 0.1) * PoseCovariance::Identity();
    const bool with_ranges = chance(0.7);
    const bool planar = chance(0.5);
    for (int i = 0; i < 4; ++i) {
      LandmarkSighting sighting;
      sighting.id = chance(0.5) ? i : LandmarkSighting::kUnknown;
      if (with_ranges) sighting.range = uniform(-0.2, 4.0);
      sighting.azimuth = uniform(-3.0, 3.0);
      if (!planar) sighting.elevation = uniform(-1.0, 1.0);
      z.sightings.push_back(sighting);
    }
    return z;
  }

  Pose pose() {
    Pose pose = planar_pose(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-M_PI, M_PI));
    pose.translation().z() = uniform(-1.0, 1.0);
    return pose;
  }

  /// All but the number of malformed sightings: what is unusable altogether enters no log.
  static bool equal(const LandmarkMapper& a, const LandmarkMapper& b) {
    const LandmarkCounts& m = a.counts();
    const LandmarkCounts& n = b.counts();
    return to_yaml(a) == to_yaml(b) && a.store().ids() == b.store().ids() && m.taken == n.taken &&
           m.wrong == n.wrong && m.merged == n.merged && m.forgotten == n.forgotten &&
           m.moved == n.moved;
  }

 private:
  ImageFeatures image() {
    ImageFeatures z;
    z.camera = {400.0, 420.0, 320.0, 240.0};
    for (int i = 0; i < 3; ++i) {
      ImageFeature feature;
      feature.id = chance(0.5) ? i : ImageFeature::kUnknown;
      feature.u = uniform(0.0, 640.0);
      feature.v = chance(0.1) ? std::nan("") : uniform(0.0, 480.0);
      z.features.push_back(feature);
    }
    return z;
  }

  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }

  std::mt19937 random_;
  LandmarkOptions options_;
};

}  // namespace portolan
