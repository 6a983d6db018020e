// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/beacon_kind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "portolan_ros/kinds/beacon_picture.hpp"

namespace portolan {
namespace {

namespace fs = std::filesystem;

BeaconMapper heard() {
  BeaconMapper mapper{BeaconOptions{}};
  for (int i = 0; i < 40; ++i) {
    const Pose pose = planar_pose(3.0 * std::cos(0.2 * i), 3.0 * std::sin(0.2 * i), 0.0);
    mapper.insert({{{5, (Eigen::Vector3d(1.0, 1.0, 0.0) - pose.translation()).norm(), 0.1}}}, pose);
  }
  return mapper;
}

class BeaconKindFiles : public testing::Test {
 protected:
  BeaconKindFiles() {
    std::string name = (fs::temp_directory_path() / "beacon_kind_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
    folder = name;
  }
  ~BeaconKindFiles() override { fs::remove_all(folder); }

  fs::path folder;
};

TEST_F(BeaconKindFiles, WhatIsSavedIsLoaded) {
  const FileSet files = BeaconKind::save(heard(), "anchors", {});
  save_files(folder, files);
  const BeaconMapper loaded = BeaconKind::load(folder, "anchors", {});
  EXPECT_EQ(BeaconKind::save(loaded, "anchors", {}), files);
}

TEST_F(BeaconKindFiles, WhatCannotBeLoadedIsCalledByItsPath) {
  const auto fault = [this](const std::string& text) -> std::string {
    save_files(folder, {{"beacons.yaml", text}});
    try {
      BeaconKind::load(folder, "beacons", {});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::string path = (folder / "beacons.yaml").string();
  EXPECT_EQ(fault("version: 2\nbeacons: []\n"), path + ": version must be 1");
  EXPECT_EQ(fault("[}").substr(0, path.size()), path);
  EXPECT_THROW(BeaconKind::load(folder, "missing", {}), std::runtime_error);
}

TEST(BeaconPicture, ShowsModesWayAndTruthWhereTheyAre) {
  BeaconScene scene;
  scene.way = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
  BeaconEstimate beacon;
  beacon.ambiguous = false;
  beacon.modes.resize(1);
  beacon.modes[0].weight = 1.0;
  beacon.modes[0].mean = {5.0, 5.0, 0.0};
  beacon.modes[0].covariance.topLeftCorner<2, 2>() = 0.01 * Eigen::Matrix2d::Identity();
  scene.beacons = {beacon};
  const Picture picture = beacon_picture(scene, 600);
  EXPECT_EQ(picture.width(), 600u);
  EXPECT_LT(picture.height(), 500u);
  const Picture without = beacon_picture({{}, scene.way, {}, {}}, 600);
  EXPECT_LT(without.height(), picture.height());
  EXPECT_EQ(beacon_picture(scene, 600).png(), picture.png());
}

TEST(BeaconPicture, OfNothingIsAPictureToo) { EXPECT_GT(beacon_picture({}, 100).width(), 0u); }

}  // namespace
}  // namespace portolan
