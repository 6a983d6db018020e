// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "portolan/landmark/landmark_mapper.hpp"
#include "portolan/landmark/scan_detectors.hpp"
#include "portolan_ros/convert/landmarks.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// What is looked for in scans.
enum class ScanDetector {
  poles,       ///< round things that stand alone
  reflectors,  ///< marks that throw back much light
  corners,     ///< where two straight walls meet
};

constexpr std::array<const char*, 3> enum_names(ScanDetector) {
  return {"poles", "reflectors", "corners"};
}

/// How landmarks are found in what is no sighting yet.
struct LandmarkFinderOptions {
  ScanDetector detector = ScanDetector::poles;
  ScanDetectorOptions detection;
  PoleOptions poles;
  ReflectorOptions reflectors;
  CornerOptions corners;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("detector", self.detector, "what is looked for in the scans on landmark_scan_topics");
    visit("detection", self.detection, "looking for landmarks in scans");
    visit("poles", self.poles, "poles, trunks, pillars");
    visit("reflectors", self.reflectors, "marks that throw back much light");
    visit("corners", self.corners, "where two straight walls meet");
  }
};

/// Makes sightings of scans, and joins the features of an image with how its camera draws. What
/// odometry states of its uncertainty goes with all of them.
class LandmarkFinder {
 public:
  using Options = LandmarkFinderOptions;
  using Observation = LandmarkMapper::Observation;

  LandmarkFinder(const Options& options, const PipelineOptions& /*pipeline*/,
                 const LandmarkMapper::Options& /*mapper*/)
      : options_(options) {}

  template <class SensorReading>
  std::vector<std::string> references(const SensorReading& /*z*/) const {
    return {};
  }

  Observation operator()(LandmarkSightings z, const PosedInput::SensorPose& pose) const {
    z.pose_covariance = pose.covariance;
    return z;
  }

  /// Unusable until the camera of that frame is known.
  Observation operator()(FramedFeatures z, const PosedInput::SensorPose& pose) const;

  /// Keeps it for the features to come.
  void note(const FramedCamera& z) { cameras_[z.frame] = z.camera; }

  /// What the detector finds.
  Observation operator()(const IntensityScan& z, const PosedInput::SensorPose& pose) const;

 private:
  LandmarkSightings detect(const IntensityScan& z) const;

  Options options_;
  std::map<std::string, PinholeCamera> cameras_;  // by frame
};

}  // namespace portolan
