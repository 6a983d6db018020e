// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace portolan {

/// How far landmarks are told apart in height.
enum class LandmarkSpace {
  automatic,  ///< in the plane where only planar sensors saw it, else anywhere
  planar,     ///< in the plane of the map
  spatial,    ///< anywhere
};

constexpr std::array<const char*, 3> enum_names(LandmarkSpace) {
  return {"automatic", "planar", "spatial"};
}

/// How a landmark takes in a further sighting.
enum class LandmarkFilter {
  ekf,  ///< linearised
  ukf,  ///< by the unscented transform
};

constexpr std::array<const char*, 2> enum_names(LandmarkFilter) { return {"ekf", "ukf"}; }

/// How sightings without identity find their landmarks.
enum class LandmarkMatching {
  nearest,  ///< each the most likely one, the most likely pair of all first
  joint,    ///< the largest set of pairs that fit together: joint compatibility
};

constexpr std::array<const char*, 2> enum_names(LandmarkMatching) { return {"nearest", "joint"}; }

/// What becomes of the identities that sensors state.
enum class StatedIdentities {
  used,     ///< what has one is itself alone; the rest is told apart by where it is
  ignored,  ///< nothing has one: for sensors that mistake them
};

constexpr std::array<const char*, 2> enum_names(StatedIdentities) { return {"used", "ignored"}; }

/// What becomes of the covariance that odometry states of its poses.
enum class StatedCovariance {
  ignored,  ///< many drivers state constants, or what has grown since the start
  used,     ///< sightings count less where the pose was vague
};

constexpr std::array<const char*, 2> enum_names(StatedCovariance) { return {"ignored", "used"}; }

/// What becomes of landmarks that were loaded from a file.
enum class LoadedLandmarks {
  prior,  ///< sightings go on moving them
  fixed,  ///< they stay as they are; new ones come beside them
};

constexpr std::array<const char*, 2> enum_names(LoadedLandmarks) { return {"prior", "fixed"}; }

}  // namespace portolan
