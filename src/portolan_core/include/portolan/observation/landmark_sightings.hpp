// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "portolan/pose_covariance.hpp"

namespace portolan {

/// One landmark as a sensor saw it. Angles as in REP 103: x forward, y left, z up.
struct LandmarkSighting {
  static constexpr std::int32_t kUnknown = -1;
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  std::int32_t id = kUnknown;       ///< identity, where the sensor recognises it
  double range = kNotMeasured;      ///< [m]; NaN: bearing only
  double azimuth = 0.0;             ///< about +z, counted from +x [rad]
  double elevation = kNotMeasured;  ///< above the xy plane [rad]; NaN: planar sensor
  double range_stddev = 0.0;        ///< one sigma; 0: unknown [m]
  double azimuth_stddev = 0.0;      ///< likewise [rad]
  double elevation_stddev = 0.0;    ///< likewise [rad]
};

/// The landmarks that one sensor saw in one moment; empty where it looked and saw none.
struct LandmarkSightings {
  std::vector<LandmarkSighting> sightings;
  /// Of the sensor's pose, along and about the sensor's own axes, where anybody stated it.
  std::optional<PoseCovariance> pose_covariance = std::nullopt;
};

/// True where the azimuth is finite, range (above 0) and elevation are finite or NaN, no deviation
/// is negative, and all is within the limits of `limits.hpp`.
bool is_usable(const LandmarkSighting& sighting);

/// True unless every sighting is malformed: the good ones are used, the others counted. No sighting
/// at all is nothing wrong.
bool is_usable(const LandmarkSightings& z);

/// What it occupies in memory [byte].
inline std::size_t byte_size(const LandmarkSightings& z) {
  return sizeof(z) + z.sightings.capacity() * sizeof(LandmarkSighting);
}

}  // namespace portolan
