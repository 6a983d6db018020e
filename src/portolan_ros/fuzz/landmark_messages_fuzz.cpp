// SPDX-License-Identifier: BSD-3-Clause
// Messages that show landmarks, of any content: what a conversion lets through, the map takes or
// refuses, and all that it holds stays a number.
#include "fuzz.hpp"
#include "portolan_ros/convert/landmarks.hpp"
#include "portolan_ros/kinds/landmark_finder.hpp"
#include "portolan_ros/odometry_covariances.hpp"

namespace portolan::fuzz {
namespace {

portolan_msgs::LandmarkSightings sightings(Bytes& bytes) {
  portolan_msgs::LandmarkSightings message;
  message.sightings.resize(bytes.next<std::uint8_t>() % 8);
  for (portolan_msgs::LandmarkSighting& sighting : message.sightings) {
    sighting.id = bytes.next<std::int8_t>();
    for (float* value :
         {&sighting.range, &sighting.azimuth, &sighting.elevation, &sighting.range_stddev,
          &sighting.azimuth_stddev, &sighting.elevation_stddev}) {
      bytes.fill(*value);
    }
  }
  return message;
}

sensor_msgs::CameraInfo camera(Bytes& bytes) {
  sensor_msgs::CameraInfo message;
  for (const std::size_t i : {0U, 5U, 2U, 6U}) bytes.fill(message.P[i]);
  for (const std::size_t i : {0U, 4U, 2U, 5U}) bytes.fill(message.K[i]);
  return message;
}

portolan_msgs::ImageFeatures features(Bytes& bytes) {
  portolan_msgs::ImageFeatures message;
  message.features.resize(bytes.next<std::uint8_t>() % 8);
  for (portolan_msgs::ImageFeature& feature : message.features) {
    feature.id = bytes.next<std::int8_t>();
    bytes.fill(feature.u);
    bytes.fill(feature.v);
  }
  return message;
}

sensor_msgs::LaserScan scan(Bytes& bytes) {
  sensor_msgs::LaserScan message;
  for (float* value : {&message.angle_min, &message.angle_increment, &message.range_max}) {
    bytes.fill(*value);
  }
  message.ranges = bytes.all<float>();
  message.intensities = message.ranges;
  return message;
}

// What odometry may state of the pose: a diagonal, and one number beside it.
PosedInput::SensorPose pose(Bytes& bytes) {
  nav_msgs::Odometry message;
  auto& covariance = message.pose.covariance;
  for (std::size_t i = 0; i < 6; ++i) covariance[7 * i] = bytes.next<float>();
  covariance[1] = covariance[6] = bytes.next<float>();
  OdometryCovariances covariances(seconds(1.0));
  covariances.receive(message, "base_link");
  PosedInput::SensorPose pose{Pose::Identity(), Pose::Identity()};
  if (const auto stated = covariances.at(Time{})) pose.covariance = stated->covariance;
  return pose;
}

void map(const LandmarkMapper::Observation& z) {
  LandmarkMapper::Options options;
  options.pose.stated = StatedCovariance::used;
  for (const LandmarkEstimate& landmark : insert_twice(LandmarkMapper(options), z).estimates()) {
    if (!landmark.mean.allFinite() || !landmark.covariance.allFinite()) {
      fail("a landmark that is nowhere");
    }
  }
}

template <class Sensed>
void map(const LandmarkFinder& finder, const Sensed& sensed, const PosedInput::SensorPose& pose) {
  if (sensed) map(finder(sensed->z, pose));
}

void convert(std::uint8_t kind, Bytes bytes) {
  LandmarkFinderOptions options;
  options.detector = static_cast<ScanDetector>(kind / 4 % 3);
  LandmarkFinder finder(options, {}, {});
  const PosedInput::SensorPose from = kind % 4 == 3 ? pose(bytes) : PosedInput::SensorPose{};
  switch (kind % 4) {
    case 0:
      return map(finder, ros_convert::intensity_scan(scan(bytes)), from);
    case 1:
      if (const auto known = ros_convert::camera_info(camera(bytes))) finder.note(known->z);
      return map(finder, ros_convert::image_features(features(bytes)), from);
    default:
      return map(finder, ros_convert::landmark_sightings(sightings(bytes)), from);
  }
}

}  // namespace
}  // namespace portolan::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) portolan::fuzz::convert(data[0], {data + 1, size - 1});
  return 0;
}
