// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "landmark/dice.hpp"
#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan::landmark_test {

inline LandmarkSighting sighting(std::int32_t id, double range, double azimuth,
                                 double elevation = LandmarkSighting::kNotMeasured) {
  LandmarkSighting sighting;
  sighting.id = id;
  sighting.range = range;
  sighting.azimuth = azimuth;
  sighting.elevation = elevation;
  return sighting;
}

inline LandmarkSightings sightings(std::vector<LandmarkSighting> list) { return {std::move(list)}; }

/// Ten landmarks about a robot that drives in circles and sees what lies ahead of it, 6 m far.
class Room {
 public:
  explicit Room(std::uint32_t seed) : dice_(seed) {
    for (LandmarkId id = 0; id < 10; ++id) {
      const double angle = 0.6283 * id;
      const double radius = 4.5 + (id % 3 == 0 ? 1.0 : 0.0);
      landmarks[id] = {radius * std::cos(angle), radius * std::sin(angle), 0.1 * id};
    }
  }

  /// Where the robot is after so many steps.
  static Pose pose(int step) {
    const double angle = 0.05 * step;
    return planar_pose(2.0 * std::cos(angle), 2.0 * std::sin(angle), angle + 0.5 * M_PI);
  }

  /// What it then sees, with errors as the options of a mapper have them.
  LandmarkSightings look(const Pose& T_map_sensor) {
    LandmarkSightings z;
    for (const auto& [id, p_map] : landmarks) {
      const Eigen::Vector3d seen = SphericalModel::h(T_map_sensor.inverse() * p_map);
      if (seen[0] > 6.0 || std::abs(seen[1]) > 1.3) continue;
      const double range = seen[0] + dice_.normal(0.05 + 0.02 * seen[0]);
      const double azimuth = seen[1] + dice_.normal(0.01);
      const double elevation = seen[2] + dice_.normal(0.01);
      z.sightings.push_back(sighting(with_identities ? id : LandmarkSighting::kUnknown,
                                     with_ranges ? range : LandmarkSighting::kNotMeasured, azimuth,
                                     elevation));
    }
    for (int i = 0; i < 3; ++i) {
      const double azimuth = dice_.uniform(-1.3, 1.3);
      const double range = dice_.uniform(1.0, 6.0);
      if (dice_.uniform(0.0, 1.0) > 1.0 / 3.0 * phantoms) continue;
      z.sightings.push_back(
          sighting(LandmarkSighting::kUnknown, range, azimuth, dice_.uniform(-0.3, 0.5)));
    }
    return z;
  }

  void drive(LandmarkMapper& mapper, int steps) {
    for (int step = 0; step < steps; ++step) mapper.insert(look(pose(step)), pose(step));
  }

  std::map<LandmarkId, Eigen::Vector3d> landmarks;
  bool with_identities = true;
  bool with_ranges = true;
  double phantoms = 0.0;  ///< sightings of nothing, on average in a message; at most 3

 private:
  Dice dice_;
};

}  // namespace portolan::landmark_test
