// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "landmark/room.hpp"

namespace portolan {
namespace {

using landmark_test::Room;
using landmark_test::sighting;
using landmark_test::sightings;

/// Points, rays, directions, flat ones and ones without identity.
LandmarkMapper mixed(const LandmarkOptions& options = {}) {
  LandmarkMapper mapper{options};
  Room room(1);
  room.drive(mapper, 30);
  mapper.insert(
      sightings({sighting(100, LandmarkSighting::kNotMeasured, 0.2, 0.1), sighting(101, 3.0, -0.2),
                 sighting(102, LandmarkSighting::kNotMeasured, 0.7)}),
      planar_pose(1.0, 2.0, 0.5));
  for (int i = 0; i < 6; ++i)
    mapper.insert(sightings({sighting(-1, 9.0, 0.5, 0.1)}), Pose::Identity());
  return mapper;
}

TEST(LandmarkFile, SavedLoadedAndSavedAgainIsEqual) {
  const std::string text = to_yaml(mixed());
  const LandmarkMapper again = landmarks_from_yaml(text, LandmarkOptions{});
  EXPECT_EQ(to_yaml(again), text);
  EXPECT_NE(text.find("kind: ray"), std::string::npos);
  EXPECT_NE(text.find("flat: true"), std::string::npos);
  EXPECT_NE(text.find("id: -2"), std::string::npos);
}

TEST(LandmarkFile, WhatRepeatsIsNotAddedTwice) {
  LandmarkOptions options;
  options.noise.repeated_stddev = 0.1;
  const std::string text = to_yaml(mixed(options));
  EXPECT_NE(text, to_yaml(mixed()));
  EXPECT_EQ(to_yaml(landmarks_from_yaml(text, options)), text);
  LandmarkMapper plain = landmarks_from_yaml(text, LandmarkOptions{});
  EXPECT_EQ(to_yaml(plain), to_yaml(mixed())) << "the filter's own covariance is in the file";
}

TEST(LandmarkFile, ALoadedMapGoesOn) {
  LandmarkMapper before = mixed();
  LandmarkMapper after = landmarks_from_yaml(to_yaml(before), LandmarkOptions{});
  Room room(2);
  Room same(2);
  room.drive(before, 50);
  same.drive(after, 50);
  ASSERT_EQ(before.estimates().size(), after.estimates().size());
  for (std::size_t i = 0; i < before.estimates().size(); ++i) {
    EXPECT_EQ(before.estimates()[i].id, after.estimates()[i].id);
    EXPECT_LT((before.estimates()[i].mean - after.estimates()[i].mean).norm(), 1e-9);
  }
}

TEST(LandmarkFile, AnEmptyMapIsAMap) {
  const LandmarkMapper empty{LandmarkOptions{}};
  EXPECT_TRUE(landmarks_from_yaml(to_yaml(empty), LandmarkOptions{}).estimates().empty());
}

TEST(LandmarkFile, AFileWrittenByHandNeedsLittle) {
  const std::string text =
      "version: 1\nlandmarks:\n  - {id: 4, mean: [1, 2, 0], covariance: [1,0,0,0,1,0,0,0,0]}\n";
  const LandmarkMapper mapper = landmarks_from_yaml(text, LandmarkOptions{});
  ASSERT_EQ(mapper.estimates().size(), 1u);
  EXPECT_EQ(mapper.estimates()[0].mean, Eigen::Vector3d(1.0, 2.0, 0.0));
}

class LandmarkFileFaults : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(LandmarkFileFaults, AreNamed) {
  const auto& [text, fault] = GetParam();
  try {
    landmarks_from_yaml(text, LandmarkOptions{});
    FAIL() << "no fault found in " << text;
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(fault), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, LandmarkFileFaults,
    ::testing::Values(
        std::make_pair("", "version"), std::make_pair("[1, 2", "line"),
        std::make_pair("version: 2\nlandmarks: []\n", "version must be 1"),
        std::make_pair("version: 1\n", "landmarks is missing"),
        std::make_pair("version: 1\nlandmarks: [{mean: [0,0,0]}]\n", "no id"),
        std::make_pair("version: 1\nlandmarks: [7]\n", "no id"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,0]}]\n", "3 numbers"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,.nan,0]}]\n", "not finite"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,0,0]}]\n", "covariance must"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,0,0], covariance: "
                       "[1,1,0,0,1,0,0,0,1]}]\n",
                       "not symmetric"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,0,0], covariance: "
                       "[1,0,0,0,-1,0,0,0,1]}]\n",
                       "negative eigenvalues"),
        std::make_pair("version: 1\nlandmarks: [{id: -1, mean: [0,0,0], covariance: "
                       "[1,0,0,0,1,0,0,0,1]}]\n",
                       "-1 says unknown"),
        std::make_pair("version: 1\nlandmarks: [{id: 1, mean: [0,0,0], covariance: "
                       "[1,0,0,0,1,0,0,0,1]}, {id: 1, mean: [0,0,0], covariance: "
                       "[1,0,0,0,1,0,0,0,1]}]\n",
                       "twice")));

}  // namespace
}  // namespace portolan
