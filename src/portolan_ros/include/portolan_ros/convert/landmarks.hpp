// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/ImageFeatures.h>
#include <portolan_msgs/LandmarkMap.h>
#include <portolan_msgs/LandmarkSightings.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>
#include <vector>

#include "portolan/landmark/landmark_mapper.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan_ros/sensed.hpp"

namespace portolan {

/// Features of an image whose camera is to be told apart by its frame.
struct FramedFeatures {
  std::string frame;
  std::vector<ImageFeature> features;
};

/// How the camera of a frame draws.
struct FramedCamera {
  std::string frame;
  PinholeCamera camera;
};

/// A scan with how bright its echoes were; none where the scanner does not say.
struct IntensityScan : RangeScan {
  std::vector<float> intensities;
};

namespace ros_convert {

/// None where every sighting of the message is malformed; single ones are left to the mapper, which
/// counts them.
std::optional<Sensed<LandmarkSightings>> landmark_sightings(
    const portolan_msgs::LandmarkSightings& message);

/// None where every feature is malformed.
std::optional<Sensed<FramedFeatures>> image_features(const portolan_msgs::ImageFeatures& message);

/// What P says of the rectified image, or K where P is empty; none where a focal length is not
/// above 0.
std::optional<Sensed<FramedCamera>> camera_info(const sensor_msgs::CameraInfo& message);

/// As `range_scan`, with intensities.
std::optional<Sensed<IntensityScan>> intensity_scan(const sensor_msgs::LaserScan& message);

/// All that the mapper knows. Header: left to the caller.
portolan_msgs::LandmarkMap landmark_map(const LandmarkMapper& mapper);

}  // namespace ros_convert

}  // namespace portolan
