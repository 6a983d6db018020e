// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/landmark_sightings.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

bool is_deviation(double stddev) { return std::isfinite(stddev) && stddev >= 0.0; }

}  // namespace

bool is_usable(const LandmarkSighting& sighting) {
  const bool range_fits =
      std::isnan(sighting.range) || (std::isfinite(sighting.range) && sighting.range > 0.0);
  return range_fits && std::isfinite(sighting.azimuth) && !std::isinf(sighting.elevation) &&
         is_deviation(sighting.range_stddev) && is_deviation(sighting.azimuth_stddev) &&
         is_deviation(sighting.elevation_stddev);
}

bool is_usable(const LandmarkSightings& z) {
  return z.sightings.empty() ||
         std::any_of(z.sightings.begin(), z.sightings.end(),
                     [](const LandmarkSighting& sighting) { return is_usable(sighting); });
}

}  // namespace portolan
