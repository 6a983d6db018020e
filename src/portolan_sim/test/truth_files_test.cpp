// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/truth_files.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <sstream>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

TEST(TruthFiles, MarksStandInTheFormatOfTheMappers) {
  WorldOptions options;
  options.landmarks.push_back({3, {1.5, -2.0, 0.25}});
  options.beacons.push_back({9, {4.0, 5.0, 6.0}});
  const FileSet files = mark_files(World(options));
  const YAML::Node landmark = YAML::Load(files.at("landmarks.yaml"))["landmarks"][0];
  EXPECT_EQ(landmark["id"].as<int>(), 3);
  EXPECT_EQ(landmark["mean"].as<std::vector<double>>(), (std::vector<double>{1.5, -2.0, 0.25}));
  EXPECT_EQ(landmark["covariance"].size(), 9U);
  const YAML::Node beacon = YAML::Load(files.at("beacons.yaml"))["beacons"][0];
  EXPECT_EQ(beacon["id"].as<int>(), 9);
  EXPECT_EQ(beacon["modes"][0]["weight"].as<double>(), 1.0);
  EXPECT_EQ(beacon["modes"][0]["mean"][2].as<double>(), 6.0);
}

TEST(TruthFiles, AWorldWithoutMarksHasEmptyLists) {
  const FileSet files = mark_files(World({}));
  EXPECT_TRUE(YAML::Load(files.at("landmarks.yaml"))["landmarks"].IsSequence());
  EXPECT_EQ(YAML::Load(files.at("beacons.yaml"))["beacons"].size(), 0U);
}

TEST(TruthFiles, ATrajectoryIsTum) {
  std::istringstream tum(to_tum({{Time{10s + 50ms}, planar_pose(1.0, 2.0, 3.14159265358979)}}));
  double stamp = 0.0;
  double x = 0.0;
  double y = 0.0;
  double z = 1.0;
  double qx = 1.0;
  double qy = 1.0;
  double qz = 0.0;
  double qw = 1.0;
  ASSERT_TRUE(tum >> stamp >> x >> y >> z >> qx >> qy >> qz >> qw);
  EXPECT_EQ(stamp, 10.05);
  EXPECT_EQ(x, 1.0);
  EXPECT_EQ(y, 2.0);
  EXPECT_EQ(z, 0.0);
  EXPECT_NEAR(qz, 1.0, 1e-9);
  EXPECT_NEAR(qw, 0.0, 1e-9);
}

}  // namespace
}  // namespace portolan::sim
