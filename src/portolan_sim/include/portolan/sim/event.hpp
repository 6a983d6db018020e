// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>

#include "portolan/observation/beacon_ranges.hpp"
#include "portolan/observation/image_features.hpp"
#include "portolan/observation/landmark_sightings.hpp"
#include "portolan/observation/range_echo.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/organized_cloud.hpp"
#include "portolan/sim/velocity.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

/// Something that the simulated robot measured, or the truth about it.
struct Event {
  /// What the wheels say.
  struct Odometry {
    Pose T_odom_base;
    Eigen::Matrix3d covariance;  ///< of x, y [m] and heading [rad], without systematic drift
    Velocity velocity;
  };
  /// Where the robot really is.
  struct Truth {
    Pose T_map_base;
    Velocity velocity;
  };
  /// A scan, and the time from beam to beam.
  struct Scan {
    RangeScan scan;
    double time_increment;  ///< [s]
  };

  using Payload = std::variant<Odometry, Truth, Scan, RangeEcho, OrganizedCloud, LandmarkSightings,
                               ImageFeatures, BeaconRanges>;

  Time stamp;         ///< of the measurement; a sweep's first beam
  Time known;         ///< when it was complete
  std::string topic;  ///< where a node would publish it
  std::string frame;  ///< of the sensor; of odometry and truth, the fixed frame
  Payload payload;
};

}  // namespace portolan::sim
