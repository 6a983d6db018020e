// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/landmark_sightings.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/limits.hpp"

namespace portolan {

bool is_usable(const LandmarkSighting& sighting) {
  const bool range_fits = std::isnan(sighting.range) || (sighting.range >= kSharpestDistance &&
                                                         sighting.range <= kFurthestReading);
  return range_fits && std::isfinite(sighting.azimuth) && !std::isinf(sighting.elevation) &&
         is_deviation(sighting.range_stddev, kWidestDistance) &&
         is_deviation(sighting.azimuth_stddev, kWidestAngle) &&
         is_deviation(sighting.elevation_stddev, kWidestAngle);
}

bool is_usable(const LandmarkSightings& z) {
  return z.sightings.empty() ||
         std::any_of(z.sightings.begin(), z.sightings.end(),
                     [](const LandmarkSighting& sighting) { return is_usable(sighting); });
}

}  // namespace portolan
