// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/landmark/landmark_options.hpp"
#include "portolan/landmark/measurement.hpp"
#include "portolan/landmark/place.hpp"

namespace portolan {

/// The point in the sensor's frame that range, azimuth and elevation show, Eq. 20 in three
/// dimensions, and its derivative, Eq. 22.
Eigen::Vector3d inverse_spherical(const Eigen::Vector3d& z);
Eigen::Matrix3d inverse_spherical_by_z(const Eigen::Vector3d& z);

/// The same for range and azimuth in the sensor's plane and the height above it [m].
Eigen::Vector3d inverse_polar(const Eigen::Vector3d& z);
Eigen::Matrix3d inverse_polar_by_z(const Eigen::Vector3d& z);

/// What one measurement with range says of a place: a point.
Place inverse_sensor_model(const Measured<SphericalModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& options);
Place inverse_sensor_model(const Measured<PolarModel>& measured, const UncertainSensorPose& sensor,
                           const LandmarkOptions& options);

/// What one measurement without range says of a place: a ray, Eq. 32, with the depth between the
/// limits of Eq. 33.
Place inverse_sensor_model(const Measured<AzimuthModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& options);
Place inverse_sensor_model(const Measured<DirectionModel>& measured,
                           const UncertainSensorPose& sensor, const LandmarkOptions& options);
Place inverse_sensor_model(const Measured<PixelModel>& measured, const UncertainSensorPose& sensor,
                           const LandmarkOptions& options);

}  // namespace portolan
