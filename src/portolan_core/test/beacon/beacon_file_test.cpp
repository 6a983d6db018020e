// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/beacon_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "beacon/scenario.hpp"

namespace portolan {
namespace {

using beacon_test::Dice;
using beacon_test::one_range;

BeaconMapper driven(int steps, std::uint32_t seed) {
  Dice dice(seed);
  BeaconMapper mapper{BeaconOptions{}};
  for (int step = 0; step < steps; ++step) {
    const Pose pose = beacon_test::figure_11(step, 12);
    for (BeaconId id = 0; id < 3; ++id) {
      const Eigen::Vector3d beacon(3.0 * id, 4.0 - 3.0 * id, 0.0);
      const double range = 1.03 * (beacon - pose.translation()).norm() + 0.05 + dice.normal(0.1);
      mapper.insert(one_range(id, range, 0.1), pose);
    }
  }
  return mapper;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(BeaconFile, SavedLoadedAndSavedAgainIsTheSame) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    for (const int steps : {0, 1, 2, 12, 60}) {
      const std::string saved = to_yaml(driven(steps, seed));
      const BeaconMapper loaded = beacons_from_yaml(saved, BeaconOptions{});
      EXPECT_EQ(to_yaml(loaded), saved) << "seed " << seed << ", steps " << steps;
    }
  }
}

TEST(BeaconFile, ALoadedMapGoesOn) {
  BeaconMapper loaded = beacons_from_yaml(to_yaml(driven(60, 1)), BeaconOptions{});
  const auto before = loaded.estimates();
  const Pose pose = beacon_test::antenna_at(2.0, 3.0);
  const Eigen::Vector3d mean = before[0].modes[0].mean;
  const RangeCalibration c = loaded.calibration();
  const double range = c.scale * (mean - pose.translation()).norm() + c.bias;
  EXPECT_EQ(loaded.insert(one_range(0, range, 0.1), pose), Outcome::inserted);
  EXPECT_EQ(loaded.estimates()[0].ranges, before[0].ranges + 1);
  EXPECT_LT((loaded.estimates()[0].modes[0].mean - mean).norm(), 0.05);
  EXPECT_LT(loaded.estimates()[0].modes[0].covariance.trace(),
            before[0].modes[0].covariance.trace());
}

TEST(BeaconFile, FaultyFilesAreRefusedWithAReason) {
  const std::string good =
      "version: 1\nbeacons:\n  - id: 4\n    ranges: 9\n    modes:\n      - weight: 1\n"
      "        mean: [1, 2, 0]\n        covariance: [1, 0.5, 0, 0.5, 1, 0, 0, 0, 0]\n";
  ASSERT_EQ(beacons_from_yaml(good, BeaconOptions{}).tracks().at(4).ranges(), 9u);
  const std::string faulty[] = {
      "",
      "beacons: [",
      "just text",
      with(good, "version: 1", "version: 2"),
      with(good, "version: 1\n", ""),
      with(good, "beacons", "bacon"),
      with(good, "weight: 1", "weight: 0.5"),
      with(good, "weight: 1", "weight: -1"),
      with(good, "weight: 1", "weight: .nan"),
      with(good, "[1, 2, 0]", "[1, 2]"),
      with(good, "[1, 2, 0]", "[1, .inf, 0]"),
      with(good, "[1, 2, 0]", "[1, two, 0]"),
      with(good, "[1, 0.5,", "[1, 0.4,"),
      with(good, "[1, 0.5, 0, 0.5,", "[1, 5, 0, 5,"),
      with(good, "0, 0, 0]", "0, 0]"),
      with(good, "id: 4", "id: -4"),
      with(good, "id: 4", "name: 4"),
      with(good, "ranges: 9", "ranges: many"),
      with(good, "version: 1", "version: 1\ncalibration: {scale: 1}"),
      good + good.substr(good.find("  - id")),
  };
  for (const std::string& text : faulty) {
    EXPECT_THROW(beacons_from_yaml(text, BeaconOptions{}), std::runtime_error) << text;
  }
}

TEST(BeaconFile, WhatIsMissingIsNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"version: 1\nlandmarks: []\n", "beacons is missing"},
      {"version: 1\nbeacons: [7]\n", "a beacon has no id"},
      {"version: 1\nbeacons: [{id: 4, ranges: 9}]\n", "beacon 4 has no modes"},
      {"version: 1\nbeacons: [{id: 4, ranges: 9, modes: [1]}]\n", "beacon 4: a mode"},
  };
  for (const auto& [text, words] : cases) {
    try {
      beacons_from_yaml(text, BeaconOptions{});
      FAIL() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace portolan
