// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_mapper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "landmark/dice.hpp"
#include "landmark/room.hpp"

namespace portolan {
namespace {

using landmark_test::Dice;
using landmark_test::Room;
using landmark_test::sighting;
using landmark_test::sightings;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(LandmarkMapper, SaysEveryFaultOfItsOptions) {
  LandmarkOptions options;
  options.noise.range_stddev = 0.0;
  options.unmeasured.min_depth = 200.0;
  try {
    const LandmarkMapper mapper(options);
    FAIL();
  } catch (const OptionsError& error) {
    EXPECT_EQ(error.faults().size(), 2u);
  }
}

TEST(LandmarkMapper, MapsIdentifiedLandmarks) {
  LandmarkMapper mapper{LandmarkOptions{}};
  Room room(1);
  room.drive(mapper, 200);
  const auto estimates = mapper.estimates();
  ASSERT_EQ(estimates.size(), room.landmarks.size());
  for (const LandmarkEstimate& e : estimates) {
    EXPECT_LT((e.mean - room.landmarks.at(e.id)).norm(), 0.05) << e.id;
    EXPECT_EQ(e.form, LandmarkForm::point);
    EXPECT_GT(e.existence, 0.99);
  }
}

TEST(LandmarkMapper, IgnoresIdentitiesWhereTheyAreNotToBeUsed) {
  LandmarkOptions options;
  options.identity.stated = StatedIdentities::ignored;
  LandmarkMapper mapper(options);
  Room room(1);
  room.drive(mapper, 200);
  EXPECT_EQ(mapper.estimates().size(), room.landmarks.size());
  for (const LandmarkEstimate& e : mapper.estimates()) EXPECT_LT(e.id, 0);
}

TEST(LandmarkMapper, PlanarLandmarksAreFlat) {
  LandmarkMapper mapper{LandmarkOptions{}};
  Pose raised = planar_pose(0.0, 0.0, 0.0);
  raised.translation().z() = 0.5;
  mapper.insert(sightings({sighting(1, 3.0, 0.2)}), raised);
  const LandmarkEstimate e = mapper.estimates().at(0);
  EXPECT_EQ(e.mean.z(), 0.0);
  EXPECT_EQ(e.covariance.col(2).norm(), 0.0);
  mapper.insert(sightings({sighting(1, 3.0, 0.2, 0.1)}), raised);
  EXPECT_NEAR(mapper.estimates().at(0).mean.z(), 0.8, 0.05);
  LandmarkOptions planar;
  planar.space = LandmarkSpace::planar;
  LandmarkMapper flat(planar);
  flat.insert(sightings({sighting(1, 3.0, 0.2, 0.1)}), raised);
  EXPECT_EQ(flat.estimates().at(0).mean.z(), 0.0);
}

TEST(LandmarkMapper, BothKindsOfSensorMapOneLandmark) {
  LandmarkMapper mapper{LandmarkOptions{}};
  const Eigen::Vector3d landmark(4.0, 0.5, 1.0);
  Pose camera = Pose::Identity();
  camera.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  const auto image = [&] {
    const Eigen::Vector3d l = camera.inverse() * landmark;
    ImageFeatures z;
    z.camera = {400.0, 400.0, 320.0, 240.0};
    z.features.push_back({7, 400.0 * l.x() / l.z() + 320.0, 400.0 * l.y() / l.z() + 240.0});
    return z;
  };
  mapper.insert(image(), camera);
  EXPECT_NE(mapper.estimates().at(0).form, LandmarkForm::point);
  const Eigen::Vector3d z = SphericalModel::h(landmark);
  mapper.insert(sightings({sighting(7, z[0], z[1], z[2])}), Pose::Identity());
  EXPECT_EQ(mapper.estimates().at(0).form, LandmarkForm::point);
  camera.translation().y() = -1.0;
  mapper.insert(image(), camera);
  ASSERT_EQ(mapper.estimates().size(), 1u);
  EXPECT_EQ(mapper.estimates()[0].sightings, 3u);
  EXPECT_LT((mapper.estimates()[0].mean - landmark).norm(), 0.05);
}

TEST(LandmarkMapper, TakesTheGoodAndCountsTheMalformed) {
  LandmarkMapper mapper{LandmarkOptions{}};
  const Pose T = Pose::Identity();
  EXPECT_EQ(mapper.insert(sightings({}), T), Outcome::inserted);
  EXPECT_EQ(mapper.insert(sightings({sighting(1, 2.0, kNan)}), T), Outcome::unusable);
  EXPECT_EQ(mapper.insert(sightings({sighting(1, -2.0, 0.1)}), T), Outcome::unusable);
  LandmarkSighting negative = sighting(1, 2.0, 0.1);
  negative.range_stddev = -0.1;
  EXPECT_EQ(mapper.insert(sightings({negative}), T), Outcome::unusable);
  EXPECT_EQ(mapper.insert(sightings({sighting(1, 0.0, 0.1), sighting(2, 2.0, 0.1)}), T),
            Outcome::inserted);
  EXPECT_EQ(mapper.counts().malformed, 4u);
  EXPECT_EQ(mapper.estimates().size(), 1u);
}

TEST(LandmarkMapper, NumbersOfAnySizeLeaveAMapOfNumbers) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const auto any = [&] { return std::pow(10.0, 15.0 * dice.normal(1.0)); };
    LandmarkOptions options;
    options.pose.stated = StatedCovariance::used;
    LandmarkMapper mapper(options);
    for (int i = 0; i < 6; ++i) {
      LandmarkSighting seen = sighting(-1, any(), any());
      seen.range_stddev = any();
      seen.azimuth_stddev = any();
      LandmarkSightings z = sightings({seen, sighting(-1, 3.0, 0.1)});
      z.pose_covariance = any() * PoseCovariance::Identity();
      mapper.insert(z, planar_pose(0.3 * i, 0.0, 0.1 * i));
    }
    for (const LandmarkEstimate& e : mapper.estimates()) {
      EXPECT_TRUE(e.mean.allFinite()) << seed;
      EXPECT_TRUE(e.covariance.allFinite()) << seed;
    }
  }
}

TEST(LandmarkMapper, ImagesWithoutFocalLengthAreUnusable) {
  LandmarkMapper mapper{LandmarkOptions{}};
  ImageFeatures z;
  z.features.push_back({1, 320.0, 240.0});
  EXPECT_EQ(mapper.insert(z, Pose::Identity()), Outcome::unusable);
  z.camera = {400.0, 0.0, 320.0, 240.0};
  EXPECT_EQ(mapper.insert(z, Pose::Identity()), Outcome::unusable);
  EXPECT_EQ(mapper.counts().malformed, 2u);
  EXPECT_EQ(mapper.store().size(), 0u);
}

TEST(LandmarkMapper, OfIdentitiesRepeatedInOneMessageTheBestSightingCounts) {
  LandmarkMapper mapper{LandmarkOptions{}};
  const Pose T = Pose::Identity();
  mapper.insert(sightings({sighting(1, 2.0, 0.0)}), T);
  mapper.insert(sightings({sighting(1, 2.5, 0.5), sighting(1, 2.01, 0.0)}), T);
  EXPECT_EQ(mapper.counts().repeated, 1u);
  EXPECT_EQ(mapper.estimates().at(0).sightings, 2u);
  EXPECT_NEAR(mapper.estimates().at(0).mean.y(), 0.0, 0.01);
}

TEST(LandmarkMapper, WrongSightingsOfAnIdentityDoNotMoveItsLandmark) {
  LandmarkMapper mapper{LandmarkOptions{}};
  Dice dice(2);
  for (int i = 0; i < 100; ++i) {
    const bool wrong = i % 5 == 4;
    mapper.insert(sightings({sighting(1, wrong ? dice.uniform(1.0, 8.0) : 3.0,
                                      wrong ? dice.uniform(-1.0, 1.0) : 0.0)}),
                  Pose::Identity());
  }
  EXPECT_LT((mapper.estimates().at(0).mean - Eigen::Vector3d(3.0, 0.0, 0.0)).norm(), 0.03);
  EXPECT_GT(mapper.counts().wrong, 15u);
  EXPECT_EQ(mapper.counts().moved, 0u);
}

TEST(LandmarkMapper, AWrongFirstSightingIsMadeGood) {
  LandmarkMapper mapper{LandmarkOptions{}};
  mapper.insert(sightings({sighting(1, 6.0, 1.0)}), Pose::Identity());
  for (int i = 0; i < 5; ++i) mapper.insert(sightings({sighting(1, 3.0, 0.0)}), Pose::Identity());
  EXPECT_NEAR(mapper.estimates().at(0).mean.x(), 3.0, 0.01);
  EXPECT_EQ(mapper.counts().moved, 1u);
}

TEST(LandmarkMapper, AMovedLandmarkIsFollowed) {
  LandmarkMapper mapper{LandmarkOptions{}};
  for (int i = 0; i < 50; ++i) mapper.insert(sightings({sighting(1, 3.0, 0.0)}), Pose::Identity());
  for (int i = 0; i < 12; ++i) mapper.insert(sightings({sighting(1, 3.0, 0.7)}), Pose::Identity());
  EXPECT_NEAR(mapper.estimates().at(0).mean.y(), 3.0 * std::sin(0.7), 0.02);
}

TEST(LandmarkMapper, RefusesALandmarkTooMany) {
  LandmarkOptions options;
  options.max_landmarks = 1;
  LandmarkMapper mapper(options);
  mapper.insert(sightings({sighting(1, 2.0, 0.0)}), Pose::Identity());
  EXPECT_EQ(mapper.insert(sightings({sighting(2, 3.0, 1.0)}), Pose::Identity()), Outcome::rejected);
  EXPECT_EQ(mapper.counts().refused, 1u);
}

TEST(LandmarkMapper, LoadedLandmarksStayWhereTheyAreIfTheyMust) {
  LandmarkMapper mapper{LandmarkOptions{}};
  mapper.insert(sightings({sighting(1, 3.0, 0.0)}), Pose::Identity());
  const std::vector<std::pair<LandmarkId, LandmarkTrack>> saved = {{1, mapper.store().at(1).track}};
  for (const LoadedLandmarks loaded : {LoadedLandmarks::prior, LoadedLandmarks::fixed}) {
    LandmarkOptions options;
    options.loaded = loaded;
    LandmarkMapper again = LandmarkMapper::restored(options, saved);
    again.insert(sightings({sighting(1, 3.1, 0.0), sighting(2, 4.0, 1.0)}), Pose::Identity());
    ASSERT_EQ(again.estimates().size(), 2u);
    EXPECT_EQ(again.estimates()[0].mean.x() == 3.0, loaded == LoadedLandmarks::fixed);
  }
}

TEST(LandmarkMapper, WhatRepeatsIsInTheCovarianceOnce) {
  LandmarkOptions options;
  LandmarkMapper without(options);
  options.noise.repeated_stddev = 0.1;
  LandmarkMapper with(options);
  for (int i = 0; i < 20; ++i) {
    const LandmarkSightings z = sightings({sighting(1, 3.0, 0.1, 0.2)});
    without.insert(z, Pose::Identity());
    with.insert(z, Pose::Identity());
  }
  const Eigen::Matrix3d more = with.estimates()[0].covariance - without.estimates()[0].covariance;
  EXPECT_LT((more - 0.01 * Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_EQ(with.estimates()[0].mean, without.estimates()[0].mean);
}

TEST(LandmarkMapper, BearingsAloneNeverMakeAPlaceQuiteSure) {
  LandmarkMapper bearings{LandmarkOptions{}};
  LandmarkMapper ranges{LandmarkOptions{}};
  for (int i = 0; i < 40; ++i) {
    const Pose T = planar_pose(0.0, 0.1 * i, 0.0);
    const double azimuth = std::atan2(-0.1 * i, 3.0);
    bearings.insert(sightings({sighting(1, LandmarkSighting::kNotMeasured, azimuth)}), T);
    ranges.insert(sightings({sighting(1, std::hypot(3.0, 0.1 * i), azimuth)}), T);
  }
  EXPECT_GT(bearings.estimates()[0].existence, 0.99);
  EXPECT_LT(bearings.estimates()[0].existence, 0.995);
  EXPECT_GT(ranges.estimates()[0].existence, 0.999999);
}

}  // namespace
}  // namespace portolan
