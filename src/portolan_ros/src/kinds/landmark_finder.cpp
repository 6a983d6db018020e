// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/landmark_finder.hpp"

#include <utility>

namespace portolan {

LandmarkMapper::Observation LandmarkFinder::operator()(FramedFeatures z,
                                                       const PosedInput::SensorPose& pose) const {
  const auto camera = cameras_.find(z.frame);
  return ImageFeatures{camera == cameras_.end() ? PinholeCamera{} : camera->second,
                       std::move(z.features), pose.covariance};
}

LandmarkMapper::Observation LandmarkFinder::operator()(const IntensityScan& z,
                                                       const PosedInput::SensorPose& pose) const {
  LandmarkSightings found = detect(z);
  found.pose_covariance = pose.covariance;
  return found;
}

LandmarkSightings LandmarkFinder::detect(const IntensityScan& z) const {
  switch (options_.detector) {
    case ScanDetector::reflectors:
      return detect_reflectors(z, z.intensities, options_.detection, options_.reflectors);
    case ScanDetector::corners:
      return detect_corners(z, options_.detection, options_.corners);
    case ScanDetector::poles:
      break;
  }
  return detect_poles(z, options_.detection, options_.poles);
}

}  // namespace portolan
