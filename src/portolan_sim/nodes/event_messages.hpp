// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <portolan_msgs/BeaconRanges.h>
#include <portolan_msgs/ImageFeatures.h>
#include <portolan_msgs/LandmarkSightings.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Header.h>

#include "portolan/sim/camera.hpp"
#include "portolan/sim/event.hpp"

namespace portolan::sim {

// What the simulated robot measured, as messages.

sensor_msgs::LaserScan message(const std_msgs::Header& header, const Event::Scan& z);
sensor_msgs::Range message(const std_msgs::Header& header, const RangeEcho& z);
/// Organised, float32 x, y, z, NaN where nothing returned.
sensor_msgs::PointCloud2 message(const std_msgs::Header& header, const OrganizedCloud& z);
portolan_msgs::LandmarkSightings message(const std_msgs::Header& header,
                                         const LandmarkSightings& z);
portolan_msgs::ImageFeatures message(const std_msgs::Header& header, const ImageFeatures& z);
portolan_msgs::BeaconRanges message(const std_msgs::Header& header, const BeaconRanges& z);

/// Without a child frame.
nav_msgs::Odometry message(const std_msgs::Header& header, const Event::Odometry& z);
/// Likewise; covariances zero.
nav_msgs::Odometry message(const std_msgs::Header& header, const Event::Truth& z);

/// How the camera draws: rectified, no distortion.
sensor_msgs::CameraInfo camera_info(const std_msgs::Header& header, const Camera::Options& camera);

}  // namespace portolan::sim
