// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/landmark/landmark_options.hpp"
#include "portolan/landmark/measurement.hpp"
#include "portolan/landmark/place.hpp"

namespace portolan {

/// How well a measurement fits a place.
struct Fit {
  double distance = 0.0;  ///< squared Mahalanobis distance, chi-squared of `size` degrees
  double log_det = 0.0;   ///< of the innovation's covariance
  int size = 0;           ///< how many numbers were measured

  /// Twice the negative log-likelihood, but for a constant: the smaller the better.
  double cost() const { return distance + log_det; }
};

/// What one pair of sighting and landmark adds to the distance of several that share the error of
/// one pose.
struct JointTerm {
  double distance_alone = 0.0;
  PoseCovariance information = PoseCovariance::Zero();  ///< of the pose's error
  Eigen::Matrix<double, 6, 1> vector = Eigen::Matrix<double, 6, 1>::Zero();  ///< times that error
  int size = 0;

  /// The squared Mahalanobis distance of all, given the covariance of the pose's error.
  double distance(const PoseCovariance& pose_covariance) const;
};

JointTerm operator+(JointTerm a, const JointTerm& b);

/// The term of a pair that fits in the sense of `fit`.
JointTerm joint_term(const Place& place, const Measurement& measurement, const Pose& T_map_sensor);

/// The fit; none where the sensor could not see the place like that (behind the camera).
std::optional<Fit> fit(const Place& place, const Measurement& measurement,
                       const UncertainSensorPose& sensor);

/// The inverse sensor model: a point for sightings with range (Eqs. 20-22), else a ray
/// (Eqs. 30-33). What is not measured comes from the options.
Place first_place(const Measurement& measurement, const UncertainSensorPose& sensor,
                  const LandmarkOptions& options);

/// The place given a further measurement: Eqs. 23-24 and 34-35, or the unscented transform. The
/// measurement's variance is divided by `trust`, in (0, 1]. Becomes a point where the depth is
/// good enough; stays as it is where the outcome is not sound. `measurement` must fit in the sense
/// of `fit`.
void update(Place& place, const Measurement& measurement, const UncertainSensorPose& sensor,
            double trust, const LandmarkOptions& options);

}  // namespace portolan
