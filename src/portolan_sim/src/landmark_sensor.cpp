// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/landmark_sensor.hpp"

#include <cmath>
#include <iterator>

namespace portolan::sim {

LandmarkSensor::LandmarkSensor(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

/// Adds the sighting, with its errors, unless it drops out.
void LandmarkSensor::sight(std::int32_t id, double range, double azimuth, double elevation,
                           LandmarkSightings& z) {
  const double measured = options_.noise.measure(range, random_);
  LandmarkSighting sighting;
  sighting.azimuth = wrap_angle(random_.normal(azimuth, options_.azimuth_stddev));
  const double tilted = random_.normal(elevation, options_.elevation_stddev);
  if (!std::isfinite(measured)) return;
  if (options_.identities) sighting.id = id;
  if (!options_.bearing_only) sighting.range = measured;
  if (!options_.planar) sighting.elevation = tilted;
  if (options_.state_stddev) {
    sighting.azimuth_stddev = options_.azimuth_stddev;
    if (!options_.bearing_only) sighting.range_stddev = options_.noise.stddev(range);
    if (!options_.planar) sighting.elevation_stddev = options_.elevation_stddev;
  }
  z.sightings.push_back(sighting);
}

/// Adds landmarks that are not there, taken for any of those that are.
void LandmarkSensor::imagine(const World& world, LandmarkSightings& z) {
  const World::Marks& landmarks = world.landmarks();
  const int phantoms = random_.count(options_.false_positives);
  for (int i = 0; i < phantoms; ++i) {
    const double range = random_.uniform(options_.noise.range_min, options_.noise.range_max);
    const double azimuth = random_.uniform(-0.5, 0.5) * options_.horizontal_view;
    const double elevation = random_.uniform(-0.5, 0.5) * options_.vertical_view;
    const auto place = static_cast<std::ptrdiff_t>(random_.index(landmarks.size()));
    const auto taken_for = std::next(landmarks.begin(), place);
    const std::int32_t id = landmarks.empty() ? LandmarkSighting::kUnknown : taken_for->first;
    sight(id, range, azimuth, elevation, z);
  }
}

LandmarkSightings LandmarkSensor::sense(const World& world, const Pose& T_map_sensor) {
  LandmarkSightings z;
  const Pose T_sensor_map = T_map_sensor.inverse();
  for (const auto& [id, p_map] : world.landmarks()) {
    const Eigen::Vector3d p_sensor = T_sensor_map * p_map;
    const double in_plane = p_sensor.head<2>().norm();
    const double range = options_.planar ? in_plane : p_sensor.norm();
    const double azimuth = std::atan2(p_sensor.y(), p_sensor.x());
    const double elevation = std::atan2(p_sensor.z(), in_plane);
    const bool in_view = range <= options_.noise.range_max &&
                         std::abs(azimuth) <= 0.5 * options_.horizontal_view &&
                         std::abs(elevation) <= 0.5 * options_.vertical_view;
    if (!in_view || !world.sees(T_map_sensor.translation(), p_map)) continue;
    sight(id, range, azimuth, elevation, z);
  }
  imagine(world, z);
  return z;
}

}  // namespace portolan::sim
