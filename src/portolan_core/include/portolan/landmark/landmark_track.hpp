// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "portolan/landmark/measurement.hpp"
#include "portolan/landmark/place.hpp"
#include "portolan/landmark/place_filter.hpp"

namespace portolan {

/// The identity that a sensor gives a landmark, 0 or above; -2 and below count those that the
/// mapper had to number itself.
using LandmarkId = std::int32_t;

/// Sensors see differently far and wide.
enum class SensorKind { sightings, image };

constexpr std::array<const char*, 2> enum_names(SensorKind) { return {"sightings", "image"}; }

/// All that the mapper knows of one landmark, or of what may become one.
class LandmarkTrack {
 public:
  /// Starts with a first sighting, `message` counted by the mapper.
  LandmarkTrack(const Measurement& first, const UncertainSensorPose& sensor,
                const LandmarkOptions& options);

  /// A track that was saved.
  LandmarkTrack(const Place& place, std::size_t sightings, double log_odds, bool has_height);

  /// Takes a sighting that passed the gate, at this squared distance from what was expected.
  void take(const Measurement& z, const UncertainSensorPose& sensor, const Fit& fit,
            const LandmarkOptions& options);

  /// Takes a sighting of the same identity that fits badly. Where enough in a row agree with each
  /// other the landmark goes where they are; true then.
  bool contradict(const Measurement& z, const UncertainSensorPose& sensor, double gate,
                  const LandmarkOptions& options);

  /// Takes note that the sensor did not see it, though it would have with this probability.
  void miss(double p_detection);

  /// Takes over what another track, which turned out to be the same landmark, knows.
  void absorb(const LandmarkTrack& other);

  const Place& place() const { return place_; }
  std::size_t sightings() const { return sightings_; }
  bool has_height() const { return has_height_; }
  double log_odds() const { return log_odds_; }
  double existence() const;  ///< P(the landmark exists)

 private:
  struct Rival {
    Place place;
    std::size_t sightings;
  };

  Place place_;
  std::optional<Rival> rival_;  // where recent sightings that did not fit would have it
  std::size_t sightings_ = 1;
  double log_odds_ = 0.0;
  bool has_height_;
};

}  // namespace portolan
