// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "landmark/room.hpp"
#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan {
namespace {

using landmark_test::Room;
using landmark_test::sighting;
using landmark_test::sightings;

constexpr std::int32_t kUnknown = LandmarkSighting::kUnknown;

/// Landmarks of the map that stand within 0.2 m of this one.
std::size_t copies(const LandmarkMapper& mapper, const Eigen::Vector3d& p_map) {
  std::size_t count = 0;
  for (const LandmarkEstimate& e : mapper.estimates()) count += (e.mean - p_map).norm() < 0.2;
  return count;
}

TEST(LandmarkIdentity, NoDoublesAfterManyRounds) {
  for (const LandmarkMatching matching : {LandmarkMatching::nearest, LandmarkMatching::joint}) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      LandmarkOptions options;
      options.identity.matching = matching;
      LandmarkMapper mapper(options);
      Room room(seed);
      room.with_identities = false;
      room.drive(mapper, 400);
      EXPECT_EQ(mapper.estimates().size(), room.landmarks.size());
      for (const auto& [id, p_map] : room.landmarks) EXPECT_EQ(copies(mapper, p_map), 1u) << id;
    }
  }
}

TEST(LandmarkIdentity, BirthsNeedRepeatedSightings) {
  LandmarkOptions options;
  options.existence.sightings = 3;
  LandmarkMapper mapper(options);
  for (std::size_t i = 1; i <= 3; ++i) {
    mapper.insert(sightings({sighting(kUnknown, 3.0, 0.2, 0.0)}), Pose::Identity());
    EXPECT_EQ(mapper.estimates().size(), i < 3 ? 0u : 1u);
  }
  EXPECT_LT(mapper.estimates().at(0).id, LandmarkSighting::kUnknown);
}

TEST(LandmarkIdentity, PhantomsDieByNegativeInformation) {
  LandmarkMapper mapper{LandmarkOptions{}};
  LandmarkOptions credulous;
  credulous.existence.forget_below = 0.0;
  LandmarkMapper hoarder(credulous);
  Room room(1);
  room.with_identities = false;
  room.phantoms = 1.0;
  Room same = room;
  room.drive(mapper, 600);
  same.drive(hoarder, 600);
  EXPECT_GT(mapper.counts().forgotten, 100u);
  EXPECT_LT(mapper.store().size(), hoarder.store().size() / 2);
  for (const auto& [id, p_map] : room.landmarks) EXPECT_EQ(copies(mapper, p_map), 1u) << id;
  EXPECT_LE(mapper.estimates().size(), room.landmarks.size() + 1);
}

TEST(LandmarkIdentity, ALandmarkThatIsGoneIsForgottenWhereItShouldBeSeen) {
  LandmarkMapper mapper{LandmarkOptions{}};
  Room room(2);
  room.with_identities = false;
  room.drive(mapper, 130);
  const Eigen::Vector3d gone = room.landmarks.at(4);
  ASSERT_EQ(copies(mapper, gone), 1u);
  room.landmarks.erase(4);
  room.drive(mapper, 4000);
  EXPECT_EQ(copies(mapper, gone), 0u);
  EXPECT_EQ(mapper.estimates().size(), room.landmarks.size());
}

TEST(LandmarkIdentity, DoublesMergeOnceTheyMeet) {
  // Two series of ranges that err against each other start two landmarks, and end as one.
  LandmarkOptions options;
  options.noise.range_stddev = 0.3;
  options.existence.sightings = 3;
  options.wrong.gate = 0.9;
  options.identity.birth_gate = 0.0;
  options.identity.merge_gate = 0.99;
  LandmarkMapper mapper(options);
  for (int i = 0; i < 3; ++i) {
    mapper.insert(sightings({sighting(kUnknown, 3.0, 0.0)}), Pose::Identity());
    mapper.insert(sightings({sighting(kUnknown, 4.2, 0.0)}), Pose::Identity());
  }
  ASSERT_EQ(mapper.estimates().size(), 2u);
  for (int i = 0; i < 40; ++i)
    mapper.insert(sightings({sighting(kUnknown, i % 2 == 0 ? 3.58 : 3.62, 0.0)}), Pose::Identity());
  EXPECT_EQ(mapper.counts().merged, 1u);
  EXPECT_EQ(mapper.estimates().size(), 1u);
}

TEST(LandmarkIdentity, WhatIsSeenSideBySideIsNeverMerged) {
  LandmarkOptions options;
  options.identity.apart = 1.0;
  options.noise.range_stddev = 0.02;
  LandmarkMapper mapper(options);
  for (int i = 0; i < 20; ++i) {
    mapper.insert(sightings({sighting(kUnknown, 3.0, 0.0), sighting(kUnknown, 3.0, 0.15)}),
                  Pose::Identity());
  }
  EXPECT_EQ(mapper.estimates().size(), 2u);
  EXPECT_EQ(mapper.counts().merged, 0u);
}

TEST(LandmarkIdentity, AnIdentityNamesALandmarkThatHadNone) {
  LandmarkMapper mapper{LandmarkOptions{}};
  for (int i = 0; i < 10; ++i)
    mapper.insert(sightings({sighting(kUnknown, 3.0, 0.0)}), Pose::Identity());
  for (int i = 0; i < 3; ++i) mapper.insert(sightings({sighting(12, 3.0, 0.0)}), Pose::Identity());
  ASSERT_EQ(mapper.estimates().size(), 1u);
  EXPECT_EQ(mapper.estimates()[0].id, 12);
  EXPECT_EQ(mapper.estimates()[0].sightings, 13u);
}

TEST(LandmarkIdentity, BearingsFindTheirLandmarks) {
  LandmarkMapper mapper{LandmarkOptions{}};
  Room room(3);
  room.with_identities = false;
  room.drive(mapper, 130);
  const std::size_t before = mapper.store().size();
  room.with_ranges = false;
  room.drive(mapper, 130);
  EXPECT_EQ(mapper.store().size(), before);
  for (const auto& [id, p_map] : room.landmarks) EXPECT_EQ(copies(mapper, p_map), 1u) << id;
}

// Figure 2 of Neira and Tardos: where the pose errs, sightings that each fit some neighbour fit
// together only as they are.
TEST(LandmarkIdentity, JointCompatibilitySeesThroughAWrongPose) {
  for (const LandmarkMatching matching : {LandmarkMatching::nearest, LandmarkMatching::joint}) {
    LandmarkOptions options;
    options.identity.matching = matching;
    options.pose.position_stddev = 0.3;
    options.existence.sightings = 1;
    LandmarkMapper mapper(options);
    const auto row = [](double shift) {
      LandmarkSightings z;
      for (int i = 0; i < 4; ++i)
        z.sightings.push_back(
            sighting(kUnknown, std::hypot(4.0, 0.5 * i + shift), std::atan2(0.5 * i + shift, 4.0)));
      return z;
    };
    for (int i = 0; i < 30; ++i) mapper.insert(row(0.0), Pose::Identity());
    ASSERT_EQ(mapper.store().size(), 4u);
    mapper.insert(row(0.3), Pose::Identity());
    const bool all_found = mapper.store().size() == 4u && mapper.counts().wrong == 0u;
    EXPECT_EQ(all_found, matching == LandmarkMatching::joint);
  }
}

}  // namespace
}  // namespace portolan
