// SPDX-License-Identifier: BSD-3-Clause
// Sensors of landmarks and beacons.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "portolan/sim/beacon_receiver.hpp"
#include "portolan/sim/camera.hpp"
#include "portolan/sim/landmark_sensor.hpp"
#include "portolan/sim/optical_frame.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

/// Landmarks and beacons alike, anywhere about the origin, nothing else.
WorldOptions marked(int marks) {
  Random random(1, "marks");
  WorldOptions world;
  for (int id = 1; id <= marks; ++id) {
    WorldOptions::Mark mark;
    mark.id = id;
    mark.position = {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(0, 1.5)};
    world.landmarks.push_back(mark);
    world.beacons.push_back(mark);
  }
  return world;
}

const Pose kPose = Eigen::Translation3d(0.1, -0.2, 0.5) * planar_pose(0.0, 0.0, 0.8);

LandmarkSensor::Options exact_sensor() {
  LandmarkSensor::Options options;
  options.noise.range_stddev = options.azimuth_stddev = options.elevation_stddev = 0.0;
  options.noise.range_max = 20.0;
  options.vertical_view = 3.1;
  return options;
}

TEST(LandmarkSensor, RangeAndAnglesLeadBackToTheLandmark) {
  const World world(marked(20));
  LandmarkSensor sensor(exact_sensor(), 1);
  const LandmarkSightings z = sensor.sense(world, kPose);
  ASSERT_EQ(z.sightings.size(), 20U);
  for (const LandmarkSighting& s : z.sightings) {
    const Eigen::Vector3d p_sensor =
        s.range * Eigen::Vector3d(std::cos(s.elevation) * std::cos(s.azimuth),
                                  std::cos(s.elevation) * std::sin(s.azimuth),
                                  std::sin(s.elevation));
    EXPECT_TRUE((kPose * p_sensor).isApprox(world.landmarks().at(s.id), 1e-9));
  }
}

TEST(LandmarkSensor, APlanarSensorSaysPlanarRangesAndNoElevation) {
  const World world(marked(20));
  LandmarkSensor::Options options = exact_sensor();
  options.planar = true;
  LandmarkSensor sensor(options, 1);
  for (const LandmarkSighting& s : sensor.sense(world, kPose).sightings) {
    EXPECT_TRUE(std::isnan(s.elevation));
    const Eigen::Vector3d offset = world.landmarks().at(s.id) - kPose.translation();
    EXPECT_NEAR(s.range, offset.head<2>().norm(), 1e-9);
  }
}

TEST(LandmarkSensor, SaysOnlyWhatItIsAskedFor) {
  LandmarkSensor::Options options = exact_sensor();
  options.identities = options.state_stddev = false;
  options.bearing_only = true;
  LandmarkSensor sensor(options, 1);
  for (const LandmarkSighting& s : sensor.sense(World(marked(20)), kPose).sightings) {
    EXPECT_EQ(s.id, LandmarkSighting::kUnknown);
    EXPECT_TRUE(std::isnan(s.range));
    EXPECT_EQ(s.azimuth_stddev, 0.0);
  }
}

TEST(LandmarkSensor, DoesNotSeeThroughWallsButThroughGlass) {
  for (const Material material : {Material::ordinary, Material::glass, Material::soft}) {
    WorldOptions options = room(4.0, material);
    options.landmarks.resize(1);
    options.landmarks[0].position = {6.0, 2.0, 0.5};
    LandmarkSensor sensor(exact_sensor(), 1);
    const auto z = sensor.sense(World(options), Pose(Eigen::Translation3d(2.0, 2.0, 0.5)));
    EXPECT_EQ(z.sightings.size(), material == Material::glass ? 1U : 0U);
  }
}

TEST(LandmarkSensor, ErrsAsItStates) {
  const World world(marked(1));
  LandmarkSensor::Options options;
  options.noise.range_max = 20.0;
  options.vertical_view = 3.1;
  options.noise.dropout = 0.1;
  LandmarkSensor exact(exact_sensor(), 1);
  LandmarkSensor sensor(options, 2);
  const LandmarkSighting truth = exact.sense(world, kPose).sightings.at(0);
  double nees = 0.0;
  int seen = 0;
  constexpr int kLooks = 10000;
  for (int i = 0; i < kLooks; ++i) {
    for (const LandmarkSighting& s : sensor.sense(world, kPose).sightings) {
      ++seen;
      nees += std::pow((s.range - truth.range) / s.range_stddev, 2) +
              std::pow((s.azimuth - truth.azimuth) / s.azimuth_stddev, 2) +
              std::pow((s.elevation - truth.elevation) / s.elevation_stddev, 2);
    }
  }
  EXPECT_NEAR(seen, 0.9 * kLooks, 120);
  EXPECT_NEAR(nees / seen, 3.0, 0.1);
}

TEST(LandmarkSensor, ImaginesAsManyAsAsked) {
  LandmarkSensor::Options options = exact_sensor();
  options.false_positives = 0.5;
  LandmarkSensor sensor(options, 3);
  std::size_t seen = 0;
  for (int i = 0; i < 4000; ++i) seen += sensor.sense(World({}), kPose).sightings.size();
  EXPECT_NEAR(static_cast<double>(seen), 2000.0, 180.0);
}

TEST(Camera, FeaturesLieOnTheRaysToTheLandmarks) {
  const World world(marked(60));
  Camera::Options options;
  options.pixel_stddev = 0.0;
  Camera camera(options, 1);
  const Pose T_map_optical = kPose * T_body_optical();
  const ImageFeatures z = camera.sense(world, T_map_optical);
  ASSERT_TRUE(is_usable(z));
  std::set<int> seen;
  for (const ImageFeature& f : z.features) {
    seen.insert(f.id);
    const Eigen::Vector3d ray((f.u - z.camera.cx) / z.camera.fx, (f.v - z.camera.cy) / z.camera.fy,
                              1.0);
    const Eigen::Vector3d to_landmark = T_map_optical.inverse() * world.landmarks().at(f.id);
    EXPECT_TRUE(ray.normalized().isApprox(to_landmark.normalized(), 1e-9));
  }
  for (const auto& [id, p_map] : world.landmarks()) {
    const Eigen::Vector3d p = kPose.inverse() * p_map;
    const bool ahead =
        p.x() > 0.0 && std::abs(p.y()) < 0.63 * p.x() && std::abs(p.z()) < 0.47 * p.x();
    if (ahead) {
      EXPECT_EQ(seen.count(id), 1U) << id;
    }
  }
  EXPECT_GT(seen.size(), 3U);
}

TEST(BeaconReceiver, MeasuresDistancesThroughWalls) {
  WorldOptions options = marked(10);
  options.walls = room(0.5).walls;
  const World world(options);
  BeaconReceiver::Options exact;
  exact.noise.range_stddev = 0.0;
  exact.bias = 0.3;
  BeaconReceiver receiver(exact, 1);
  const BeaconRanges z = receiver.sense(world, kPose);
  ASSERT_EQ(z.ranges.size(), 10U);
  for (const BeaconRange& range : z.ranges) {
    const Eigen::Vector3d& p_map = world.beacons().at(static_cast<int>(range.id));
    EXPECT_NEAR(range.range, (p_map - kPose.translation()).norm() + 0.3, 1e-9);
  }
  exact.line_of_sight = true;
  BeaconReceiver sighted(exact, 1);
  EXPECT_LT(sighted.sense(world, Pose(Eigen::Translation3d(0.2, 0.2, 0.5))).ranges.size(), 3U);
}

TEST(BeaconReceiver, EachBeaconKeepsItsOwnBias) {
  const World world(marked(200));
  BeaconReceiver::Options options;
  options.noise.range_stddev = 0.0;
  options.bias_stddev = 0.5;
  BeaconReceiver receiver(options, 1);
  const BeaconRanges first = receiver.sense(world, kPose);
  const BeaconRanges second = receiver.sense(world, kPose);
  double squares = 0.0;
  for (std::size_t i = 0; i < first.ranges.size(); ++i) {
    EXPECT_EQ(first.ranges[i].range, second.ranges[i].range);
    const Eigen::Vector3d& p_map = world.beacons().at(static_cast<int>(first.ranges[i].id));
    squares += std::pow(first.ranges[i].range - (p_map - kPose.translation()).norm(), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 200.0), 0.5, 0.08);
}

TEST(BeaconReceiver, TakesTurnsWhereAsked) {
  const World world(marked(3));
  BeaconReceiver::Options options;
  options.one_at_a_time = true;
  BeaconReceiver receiver(options, 1);
  for (const std::uint32_t id : {1U, 2U, 3U, 1U}) {
    const BeaconRanges z = receiver.sense(world, kPose);
    ASSERT_EQ(z.ranges.size(), 1U);
    EXPECT_EQ(z.ranges[0].id, id);
  }
}

}  // namespace
}  // namespace portolan::sim
