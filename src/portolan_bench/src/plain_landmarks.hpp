// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "portolan/observation/landmark_sightings.hpp"
#include "portolan/pose.hpp"

namespace portolan::bench {

/// What one would write first: Eqs. 20-24 in the plane, an EKF for each landmark in a hash map.
/// A sighting without identity is compared with every landmark there is.
class PlainLandmarks {
 public:
  void insert(const LandmarkSightings& z, const Pose& T_map_sensor);

  struct Landmark {
    Eigen::Vector2d mean;
    Eigen::Matrix2d covariance;
  };
  const std::unordered_map<std::int32_t, Landmark>& landmarks() const { return landmarks_; }

 private:
  std::int32_t nearest(const LandmarkSighting& sighting, const Pose& T_map_sensor) const;

  std::unordered_map<std::int32_t, Landmark> landmarks_;
};

}  // namespace portolan::bench
