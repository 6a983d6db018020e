// SPDX-License-Identifier: BSD-3-Clause
#include "plain_landmarks.hpp"

#include <Eigen/LU>
#include <cmath>

namespace portolan::bench {

namespace {

constexpr double kGate = 13.8;  // chi-squared, 2 degrees, 0.999

struct Innovation {
  Eigen::Vector2d nu;
  Eigen::Matrix2d H;
};

Innovation innovation(const PlainLandmarks::Landmark& landmark, const LandmarkSighting& z,
                      const Pose& T_map_sensor) {
  const double dx = landmark.mean.x() - T_map_sensor.translation().x();
  const double dy = landmark.mean.y() - T_map_sensor.translation().y();
  const double r = std::hypot(dx, dy);
  Innovation i;
  i.nu = {z.range - r, wrap_angle(z.azimuth - std::atan2(dy, dx) + yaw(T_map_sensor))};
  i.H << dx / r, dy / r, -dy / (r * r), dx / (r * r);
  return i;
}

Eigen::Matrix2d noise(const LandmarkSighting& z) {
  return Eigen::Vector2d(z.range_stddev * z.range_stddev, z.azimuth_stddev * z.azimuth_stddev)
      .asDiagonal();
}

PlainLandmarks::Landmark first(const LandmarkSighting& z, const Pose& T_map_sensor) {
  const double angle = z.azimuth + yaw(T_map_sensor);
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  Eigen::Matrix2d J;
  J << u.x(), -z.range * u.y(), u.y(), z.range * u.x();
  return {T_map_sensor.translation().head<2>() + z.range * u, J * noise(z) * J.transpose()};
}

}  // namespace

void PlainLandmarks::insert(const LandmarkSightings& z, const Pose& T_map_sensor) {
  for (const LandmarkSighting& sighting : z.sightings) {
    const bool known = sighting.id != LandmarkSighting::kUnknown;
    const std::int32_t id = known ? sighting.id : nearest(sighting, T_map_sensor);
    const auto found = landmarks_.find(id);
    if (found == landmarks_.end()) {
      landmarks_.emplace(id, first(sighting, T_map_sensor));
      continue;
    }
    Landmark& m = found->second;
    const auto [nu, H] = innovation(m, sighting, T_map_sensor);
    const Eigen::Matrix2d S = H * m.covariance * H.transpose() + noise(sighting);
    const Eigen::Matrix2d K = m.covariance * H.transpose() * S.inverse();
    m.mean += K * nu;
    m.covariance = (Eigen::Matrix2d::Identity() - K * H) * m.covariance;
  }
}

std::int32_t PlainLandmarks::nearest(const LandmarkSighting& sighting,
                                     const Pose& T_map_sensor) const {
  auto best = static_cast<std::int32_t>(landmarks_.size());
  double least = kGate;
  for (const auto& [id, landmark] : landmarks_) {
    const auto [nu, H] = innovation(landmark, sighting, T_map_sensor);
    const Eigen::Matrix2d S = H * landmark.covariance * H.transpose() + noise(sighting);
    const double distance = nu.dot(S.inverse() * nu);
    if (distance >= least) continue;
    least = distance;
    best = id;
  }
  return best;
}

}  // namespace portolan::bench
