// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/landmarks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "portolan_ros/convert/landmark_markers.hpp"
#include "portolan_ros/kinds/landmark_finder.hpp"

namespace portolan {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

portolan_msgs::LandmarkSighting sighting(std::int32_t id, float range, float azimuth,
                                         float elevation) {
  portolan_msgs::LandmarkSighting message;
  message.id = id;
  message.range = range;
  message.azimuth = azimuth;
  message.elevation = elevation;
  message.range_stddev = 0.1F;
  return message;
}

sensor_msgs::CameraInfo camera(double focal_length) {
  sensor_msgs::CameraInfo message;
  message.header.frame_id = "/camera";
  message.K[0] = focal_length;
  message.K[4] = focal_length;
  message.K[2] = 320.0;
  message.K[5] = 240.0;
  return message;
}

TEST(LandmarkConversion, SightingsKeepAllTheySay) {
  portolan_msgs::LandmarkSightings message;
  message.header.frame_id = "laser";
  message.header.stamp = ros::Time(12, 5);
  message.sightings = {sighting(3, 2.0F, 0.5F, kNan), sighting(-1, kNan, 0.25F, 0.125F)};
  const auto sensed = ros_convert::landmark_sightings(message);
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->frame, "laser");
  EXPECT_EQ(sensed->first, Time(std::chrono::nanoseconds(12'000'000'005)));
  ASSERT_EQ(sensed->z.sightings.size(), 2u);
  EXPECT_EQ(sensed->z.sightings[0].id, 3);
  EXPECT_EQ(sensed->z.sightings[0].range, 2.0);
  EXPECT_TRUE(std::isnan(sensed->z.sightings[0].elevation));
  EXPECT_EQ(sensed->z.sightings[0].range_stddev, static_cast<double>(0.1F));
  EXPECT_TRUE(std::isnan(sensed->z.sightings[1].range));
  EXPECT_EQ(sensed->z.sightings[1].elevation, 0.125);
}

TEST(LandmarkConversion, MessagesWithoutAGoodSightingAreMalformed) {
  portolan_msgs::LandmarkSightings message;
  EXPECT_TRUE(ros_convert::landmark_sightings(message));  // it looked and saw none
  message.sightings = {sighting(3, 2.0F, kNan, kNan)};
  EXPECT_FALSE(ros_convert::landmark_sightings(message));
  message.sightings.push_back(sighting(3, -2.0F, 0.1F, kNan));
  EXPECT_FALSE(ros_convert::landmark_sightings(message));
  message.sightings.push_back(sighting(3, 2.0F, 0.1F, kNan));
  EXPECT_TRUE(ros_convert::landmark_sightings(message));
}

TEST(LandmarkConversion, CamerasAreThoseOfTheRectifiedImage) {
  sensor_msgs::CameraInfo message = camera(400.0);
  EXPECT_EQ(ros_convert::camera_info(message)->z.camera.fx, 400.0);
  EXPECT_EQ(ros_convert::camera_info(message)->z.frame, "camera");
  message.P[0] = 380.0;
  message.P[5] = 381.0;
  message.P[2] = 310.0;
  message.P[6] = 230.0;
  const PinholeCamera rectified = ros_convert::camera_info(message)->z.camera;
  EXPECT_EQ(rectified.fx, 380.0);
  EXPECT_EQ(rectified.fy, 381.0);
  EXPECT_EQ(rectified.cx, 310.0);
  EXPECT_EQ(rectified.cy, 230.0);
  EXPECT_FALSE(ros_convert::camera_info(camera(0.0)));
  EXPECT_FALSE(ros_convert::camera_info(camera(std::nan(""))));
}

TEST(LandmarkConversion, FeaturesWaitForTheirCamera) {
  portolan_msgs::ImageFeatures message;
  message.header.frame_id = "camera";
  message.features.resize(1);
  message.features[0].u = 100.0F;
  const auto features = ros_convert::image_features(message);
  ASSERT_TRUE(features);
  LandmarkFinder finder({}, {}, {});
  const PosedInput::SensorPose pose{Pose::Identity(), Pose::Identity()};
  EXPECT_FALSE(is_usable(std::get<ImageFeatures>(finder(features->z, pose))));
  finder.note(ros_convert::camera_info(camera(400.0))->z);
  EXPECT_TRUE(is_usable(std::get<ImageFeatures>(finder(features->z, pose))));
  message.features[0].u = kNan;
  EXPECT_FALSE(ros_convert::image_features(message));
}

/// A point that has an identity, and a ray that has none.
LandmarkMapper example() {
  LandmarkOptions options;
  options.existence.sightings = 1;
  LandmarkMapper mapper(options);
  LandmarkSightings z;
  z.sightings.resize(2);
  z.sightings[0].id = 7;
  z.sightings[0].range = 2.0;
  z.sightings[1].azimuth = 1.0;
  z.sightings[1].elevation = 0.2;
  mapper.insert(z, Pose::Identity());
  return mapper;
}

TEST(LandmarkConversion, TheMapSaysWhatTheMapperKnows) {
  const LandmarkMapper mapper = example();
  const portolan_msgs::LandmarkMap map = ros_convert::landmark_map(mapper);
  ASSERT_EQ(map.landmarks.size(), 2u);
  EXPECT_EQ(map.sightings_taken, 2u);
  const portolan_msgs::Landmark& ray = map.landmarks[0];
  const portolan_msgs::Landmark& point = map.landmarks[1];
  EXPECT_EQ(point.id, 7);
  EXPECT_EQ(point.kind, portolan_msgs::Landmark::POINT);
  EXPECT_EQ(point.position.x, 2.0);
  EXPECT_EQ(point.position.z, 0.0);
  EXPECT_EQ(point.covariance[0], mapper.estimates()[1].covariance(0, 0));
  EXPECT_EQ(point.covariance[8], 0.0);
  EXPECT_EQ(ray.id, -2);
  EXPECT_NE(ray.kind, portolan_msgs::Landmark::POINT);
  EXPECT_GT(ray.ray_mean.z, 0.0);
  EXPECT_EQ(ray.ray_covariance[8], mapper.estimates()[0].place.covariance(2, 2));
}

TEST(LandmarkConversion, MarkersAreEllipsoidsOrArrows) {
  portolan_msgs::LandmarkMap map = ros_convert::landmark_map(example());
  map.landmarks[0].kind = portolan_msgs::Landmark::DIRECTION;
  const auto markers = ros_convert::landmark_markers(map, 2.0).markers;
  ASSERT_EQ(markers.size(), 5u);  // delete all, arrow, dot, ellipsoid, label
  EXPECT_EQ(markers[1].type, visualization_msgs::Marker::ARROW);
  EXPECT_EQ(markers[2].ns, "places");
  EXPECT_GT(markers[2].scale.x, 0.1) << "to be seen however well it is known";
  EXPECT_EQ(markers[3].type, visualization_msgs::Marker::SPHERE);
  EXPECT_EQ(markers[4].text, "7");
  EXPECT_GT(markers[3].scale.z, 0.0);
}

TEST(LandmarkConversion, ARayIsDrawnFromWhereItWasFirstSeen) {
  portolan_msgs::LandmarkMap map = ros_convert::landmark_map(example());
  map.landmarks.resize(1);
  map.landmarks[0].kind = portolan_msgs::Landmark::RAY;
  map.landmarks[0].ray.position.x = 5.0;
  const auto markers = ros_convert::landmark_markers(map, 2.0).markers;
  ASSERT_EQ(markers.size(), 5u);  // delete all, ray, dot, ellipsoid, label
  ASSERT_EQ(markers[1].type, visualization_msgs::Marker::LINE_STRIP);
  ASSERT_EQ(markers[1].points.size(), 2u);
  EXPECT_EQ(markers[1].points[0].x, 5.0);
  EXPECT_EQ(markers[1].points[1].x, map.landmarks[0].position.x);
}

}  // namespace
}  // namespace portolan
