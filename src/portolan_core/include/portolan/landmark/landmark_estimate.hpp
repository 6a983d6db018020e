// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "portolan/landmark/landmark_track.hpp"

namespace portolan {

/// How much is known of where a landmark is.
enum class LandmarkForm {
  point,      ///< x, y, z
  ray,        ///< a direction and an uncertain depth
  direction,  ///< a direction; the depth may be infinite
};

constexpr std::array<const char*, 3> enum_names(LandmarkForm) {
  return {"point", "ray", "direction"};
}

/// What a map says of one landmark.
struct LandmarkEstimate {
  LandmarkId id = 0;
  LandmarkForm form = LandmarkForm::point;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();        ///< in the map [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< linearised where it is no point [m^2]
  std::size_t sightings = 0;
  double existence = 0.0;  ///< probability
  Place place;             ///< as it is estimated
};

/// Sightings that a mapper took and that it could not take.
struct LandmarkCounts {
  std::size_t taken = 0;
  std::size_t malformed = 0;  ///< not finite, negative
  std::size_t repeated = 0;   ///< of an identity that a better one of the message had
  std::size_t wrong = 0;      ///< that fit no landmark, or not the one whose identity they had
  std::size_t refused = 0;    ///< of a landmark too many
  std::size_t merged = 0;     ///< landmarks that turned out to be others
  std::size_t forgotten = 0;  ///< landmarks that were not seen where they should be
  std::size_t moved = 0;      ///< identified landmarks that were found elsewhere
};

}  // namespace portolan
