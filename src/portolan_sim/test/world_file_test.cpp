// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/world_file.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "portolan/sim/truth_grid.hpp"
#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

class WorldFile : public ::testing::Test {
 protected:
  std::string yaml = ::testing::TempDir() + "portolan_sim_world.yaml";
  std::string pgm = ::testing::TempDir() + "portolan_sim_world.pgm";

  void TearDown() override {
    std::remove(yaml.c_str());
    std::remove(pgm.c_str());
  }

  std::string complaint() {
    try {
      read_world(yaml);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(WorldFile, ReadsWallsBoxesCylindersAndMarks) {
  write(yaml,
        "walls:\n  - {points: [[0, 0], [4, 0], [4, 3]], material: glass}\n"
        "boxes:\n  - {center: [1, 1], size: [0.5, 0.2], yaw: 0.3, height: 0.7}\n"
        "cylinders:\n  - {center: [2, 2], radius: 0.1, material: soft}\n"
        "landmarks:\n  - {id: 3, position: [1, 2, 0.5]}\n"
        "tour: [[1, 1], [2, 1]]\n");
  const WorldOptions options = read_world(yaml);
  const World world(options);
  ASSERT_EQ(world.obstacles().size(), 4U);
  EXPECT_EQ(world.obstacles()[0].material, Material::glass);
  EXPECT_EQ(world.obstacles()[2].top, 0.7);
  EXPECT_EQ(world.obstacles()[3].material, Material::soft);
  EXPECT_EQ(world.landmarks().at(3), Eigen::Vector3d(1, 2, 0.5));
  EXPECT_EQ(options.tour.size(), 2U);
}

TEST_F(WorldFile, AMapThatWasWrittenIsTheWorldThatItCameFrom) {
  WorldOptions options = room(2.0);
  WorldOptions::Box block;
  block.center = {1.25, 0.75};
  block.size = {0.3, 0.5};
  options.boxes.push_back(block);
  const TruthGrid grid = truth_grid(World(options), 0.05, 0.2, {0.2, 0.2});
  write(pgm, to_pgm(to_picture(grid)));
  write(yaml, to_map_yaml(to_picture(grid), "portolan_sim_world.pgm"));
  const TruthGrid again = truth_grid(World(read_world(yaml)), 0.05, 0.2, {0.2, 0.2});
  EXPECT_EQ(to_text(again), to_text(grid));
  EXPECT_NEAR(again.origin.x(), grid.origin.x(), 1e-9);
}

TEST_F(WorldFile, FaultsNameTheFileAndWhatIsWrong) {
  EXPECT_NE(complaint().find(yaml), std::string::npos);
  write(yaml, "wals: []\nboxes: [{size: [1, -1]}]\n");
  EXPECT_NE(complaint().find("wals"), std::string::npos);
  EXPECT_NE(complaint().find("-1"), std::string::npos);
  write(yaml, "image: portolan_sim_world.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n");
  EXPECT_NE(complaint().find("cannot be opened"), std::string::npos);
  write(pgm, "P5\n# made by hand\n10 10\n255\nfew");
  EXPECT_NE(complaint().find("does not fit its header"), std::string::npos);
  write(pgm, "P2\n1 1\n255\n0");
  EXPECT_NE(complaint().find("P5"), std::string::npos);
}

}  // namespace
}  // namespace portolan::sim
