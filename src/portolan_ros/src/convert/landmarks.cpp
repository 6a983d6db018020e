// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/landmarks.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/eigen_messages.hpp"
#include "portolan_ros/convert/ranges.hpp"

namespace portolan::ros_convert {

namespace {

LandmarkSighting sighting(const portolan_msgs::LandmarkSighting& message) {
  LandmarkSighting sighting;
  sighting.id = message.id;
  sighting.range = message.range;
  sighting.azimuth = message.azimuth;
  sighting.elevation = message.elevation;
  sighting.range_stddev = message.range_stddev;
  sighting.azimuth_stddev = message.azimuth_stddev;
  sighting.elevation_stddev = message.elevation_stddev;
  return sighting;
}

portolan_msgs::Landmark landmark(const LandmarkEstimate& estimate) {
  portolan_msgs::Landmark message;
  message.id = estimate.id;
  message.kind = static_cast<std::uint8_t>(estimate.form);
  message.position = vector<geometry_msgs::Point>(estimate.mean);
  fill(estimate.covariance, message.covariance);
  message.sightings = static_cast<std::uint32_t>(estimate.sightings);
  message.existence = estimate.existence;
  message.ray.orientation.w = 1.0;
  if (estimate.place.form == PlaceForm::point) return message;
  message.ray = pose(estimate.place.T_map_ray);
  message.ray_mean = vector<geometry_msgs::Vector3>(estimate.place.mean);
  fill(estimate.place.covariance, message.ray_covariance);
  return message;
}

static_assert(static_cast<int>(LandmarkForm::point) == portolan_msgs::Landmark::POINT);
static_assert(static_cast<int>(LandmarkForm::ray) == portolan_msgs::Landmark::RAY);
static_assert(static_cast<int>(LandmarkForm::direction) == portolan_msgs::Landmark::DIRECTION);

}  // namespace

std::optional<Sensed<LandmarkSightings>> landmark_sightings(
    const portolan_msgs::LandmarkSightings& message) {
  LandmarkSightings z;
  z.sightings.reserve(message.sightings.size());
  for (const portolan_msgs::LandmarkSighting& seen : message.sightings) {
    z.sightings.push_back(sighting(seen));
  }
  if (!is_usable(z)) return std::nullopt;
  const Time stamp = time(message.header.stamp);
  const std::uint64_t part = part_about(z.sightings);
  return Sensed<LandmarkSightings>{message.header.frame_id, stamp, stamp, std::move(z), part};
}

std::optional<Sensed<FramedFeatures>> image_features(const portolan_msgs::ImageFeatures& message) {
  FramedFeatures z{without_slash(message.header.frame_id), {}};
  z.features.reserve(message.features.size());
  for (const portolan_msgs::ImageFeature& feature : message.features) {
    z.features.push_back({feature.id, feature.u, feature.v});
  }
  const bool any_usable =
      std::any_of(z.features.begin(), z.features.end(),
                  [](const ImageFeature& feature) { return is_usable(feature); });
  if (!any_usable && !z.features.empty()) return std::nullopt;
  const Time stamp = time(message.header.stamp);
  const std::uint64_t part = part_about(z.features);
  return Sensed<FramedFeatures>{message.header.frame_id, stamp, stamp, std::move(z), part};
}

std::optional<Sensed<FramedCamera>> camera_info(const sensor_msgs::CameraInfo& message) {
  const auto& K = message.K;
  const auto& P = message.P;
  const bool is_rectified = P[0] != 0.0;
  const FramedCamera z{
      without_slash(message.header.frame_id),
      is_rectified ? PinholeCamera{P[0], P[5], P[2], P[6]} : PinholeCamera{K[0], K[4], K[2], K[5]}};
  if (!is_usable(z.camera)) return std::nullopt;
  const Time stamp = time(message.header.stamp);
  return Sensed<FramedCamera>{message.header.frame_id, stamp, stamp, z};
}

std::optional<Sensed<IntensityScan>> intensity_scan(const sensor_msgs::LaserScan& message) {
  std::optional<Sensed<RangeScan>> scan = range_scan(message);
  if (!scan) return std::nullopt;
  IntensityScan z{std::move(scan->z), message.intensities};
  return Sensed<IntensityScan>{scan->frame, scan->first, scan->last, std::move(z)};
}

portolan_msgs::LandmarkMap landmark_map(const LandmarkMapper& mapper) {
  portolan_msgs::LandmarkMap message;
  for (const LandmarkEstimate& estimate : mapper.estimates()) {
    message.landmarks.push_back(landmark(estimate));
  }
  message.sightings_taken = mapper.counts().taken;
  message.sightings_malformed = mapper.counts().malformed;
  message.sightings_repeated = mapper.counts().repeated;
  message.sightings_wrong = mapper.counts().wrong;
  message.sightings_refused = mapper.counts().refused;
  return message;
}

}  // namespace portolan::ros_convert
