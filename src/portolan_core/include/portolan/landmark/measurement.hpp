// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>

#include "portolan/landmark/landmark_options.hpp"
#include "portolan/landmark/sensor_models.hpp"
#include "portolan/observation/image_features.hpp"
#include "portolan/observation/landmark_sightings.hpp"
#include "portolan/pose.hpp"
#include "portolan/pose_covariance.hpp"

namespace portolan {

/// What a sensor of one kind measured of a landmark, with independent errors.
template <class Model>
struct Measured {
  Model model;
  typename Model::Vector z;
  typename Model::Vector variance;
};

/// What any sensor measured of a landmark.
using Measurement =
    std::variant<Measured<PolarModel>, Measured<SphericalModel>, Measured<AzimuthModel>,
                 Measured<DirectionModel>, Measured<PixelModel>>;

/// Where the sensor was, and how well that is known.
struct UncertainSensorPose {
  Pose T_map_sensor = Pose::Identity();
  bool is_certain = true;
  PoseCovariance covariance = PoseCovariance::Zero();  ///< along and about the map's axes
};

/// With the deviations of the options and, where these ask for it, the covariance that goes with
/// the observation, along and about the sensor's axes.
UncertainSensorPose uncertain(const Pose& T_map_sensor, const std::optional<PoseCovariance>& stated,
                              const LandmarkPoseOptions& options);

/// The measurement in a well-formed sighting; deviations that it does not state are the options'.
Measurement measurement_of(const LandmarkSighting& sighting, const SightingNoiseOptions& noise);

/// The measurement in a well-formed feature of an image.
Measurement measurement_of(const ImageFeature& feature, const PinholeCamera& camera,
                           const SightingNoiseOptions& noise);

/// The point in the map that a sighting with range shows (in the sensor's plane where it is a
/// planar one), Eq. 20; none for one without.
std::optional<Eigen::Vector3d> shown_point(const Measurement& measurement,
                                           const Pose& T_map_sensor);

/// The unit vector in the map from the sensor to the landmark.
Eigen::Vector3d shown_direction(const Measurement& measurement, const Pose& T_map_sensor);

/// False for measurements in a plane, which say nothing of the height.
bool tells_height(const Measurement& measurement);

}  // namespace portolan
