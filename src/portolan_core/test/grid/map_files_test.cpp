// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/map_files.hpp"

#include <gtest/gtest.h>

#include <string>

#include "grid/random_observations.hpp"
#include "portolan/grid/map_picture.hpp"

namespace portolan {
namespace {

GridMapper random_map(std::uint32_t seed) {
  RandomObservations random(seed);
  GridMapper map(random.options());
  for (int i = 0; i < 10; ++i) {
    map.insert(random.observation(map.options()), random.pose(map.options()));
  }
  return map;
}

class MapFiles : public ::testing::TestWithParam<PixelMode> {};

TEST_P(MapFiles, SaveLoadSaveGivesEqualFiles) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const GridMapper map = random_map(seed);
    const FileSet files = map_files(map, GetParam());
    const GridMapper loaded = read_map_files(files, "map", map.options());
    const FileSet again = map_files(loaded, GetParam());
    ASSERT_EQ(files.size(), again.size());
    for (const auto& [name, content] : files) {
      EXPECT_TRUE(again.at(name) == content)
          << "seed " << seed << " " << name << " fusion " << static_cast<int>(map.options().fusion);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, MapFiles, ::testing::Values(PixelMode::trinary, PixelMode::scale));

// A map of 3 x 2 cells as map_server's users draw it.
FileSet drawn() {
  return {{"map.yaml",
           "image: map.pgm\nresolution: 0.05\norigin: [-0.1, 0.05, 0.0]\nnegate: 0\n"
           "occupied_thresh: 0.65\nfree_thresh: 0.196\n"},
          {"map.pgm", std::string("P5\n# drawn by hand\n3 2\n255\n\x00\xFE\xCD\xFE\xFE\x00", 33)}};
}

TEST(MapFilesOfOthers, LayersThatTheyDoNotNameAreNotTheirs) {
  FileSet files = drawn();
  files["map_sonar.yaml"] = files["map.yaml"];
  EXPECT_EQ(read_map_files(files, "map", GridOptions{}).layers(),
            std::vector<GridLayer>{GridLayer::laser});
  files["map.yaml"] += "layers: [sonar]\n";
  EXPECT_EQ(read_map_files(files, "map", GridOptions{}).layers(),
            std::vector<GridLayer>{GridLayer::sonar});
}

TEST(MapFilesOfOthers, BecomeTheLaserLayer) {
  const GridMapper map = read_map_files(drawn(), "map", GridOptions{});
  EXPECT_EQ(map.layers(), std::vector<GridLayer>{GridLayer::laser});
  EXPECT_EQ(map.bounds(), (CellRect{{-2, 1}, {1, 3}}));
  EXPECT_LT(*map.probability({-2, 1}), 0.03);
  EXPECT_GT(*map.probability({0, 1}), 0.97);
  EXPECT_GT(*map.probability({-2, 2}), 0.97);
  EXPECT_FALSE(map.probability({0, 2}).has_value());
  EXPECT_EQ(map_files(map, PixelMode::trinary).at("map.pgm").substr(11),
            drawn().at("map.pgm").substr(27));
}

TEST(MapFilesOfOthers, MayBeNegated) {
  FileSet files = drawn();
  std::string& yaml = files["map.yaml"];
  yaml.replace(yaml.find("negate: 0"), 9, "negate: 1");
  const GridMapper map = read_map_files(files, "map", GridOptions{});
  EXPECT_GT(*map.probability({-2, 1}), 0.97);
  EXPECT_LT(*map.probability({0, 1}), 0.03);
}

struct Fault {
  const char* file;
  const char* find;
  const char* replace;
  const char* reason;
};

class MapFileFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(MapFileFaults, AreNamed) {
  FileSet files = drawn();
  std::string& content = files.at(GetParam().file);
  const std::size_t at = content.find(GetParam().find);
  ASSERT_NE(at, std::string::npos);
  content.replace(at, std::string(GetParam().find).size(), GetParam().replace);
  try {
    read_map_files(files, "map", GridOptions{});
    FAIL() << "was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().file), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(GetParam().reason), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, MapFileFaults,
    ::testing::Values(Fault{"map.yaml", "image: map.pgm", "version: 2\nimage: map.pgm", "version"},
                      Fault{"map.yaml", "resolution: 0.05", "resolution: 0.025", "resolution"},
                      Fault{"map.yaml", "resolution: 0.05", "resolution: .nan", "finite"},
                      Fault{"map.yaml", "resolution: 0.05", "resolution: -1", "above 0"},
                      Fault{"map.yaml", "resolution: 0.05", "", "missing"},
                      Fault{"map.yaml", "[-0.1, 0.05, 0.0]", "[-0.1, 0.05, 0.3]", "yaw"},
                      Fault{"map.yaml", "[-0.1, 0.05, 0.0]", "[-0.12, 0.05, 0.0]", "corner"},
                      Fault{"map.yaml", "[-0.1, 0.05, 0.0]", "[1e300, 0.05, 0.0]", "far"},
                      Fault{"map.yaml", "[-0.1, 0.05, 0.0]", "[.inf, 0.05, 0.0]", "finite"},
                      Fault{"map.yaml", "negate: 0", "mode: raw", "trinary or scale"},
                      Fault{"map.yaml", "0.65", "1.5", "occupied_thresh <= 1"},
                      Fault{"map.yaml", "0.65", "0.1", "free_thresh <= occupied_thresh"},
                      Fault{"map.yaml", "0.196", "-0.1", "0 <= free_thresh"},
                      Fault{"map.yaml", "negate: 0", "layers: [radar]", "one of laser"},
                      Fault{"map.yaml", "negate: 0", "layers: 3", "list"},
                      Fault{"map.yaml", "image: map.pgm", "image: ../map.pgm", "bare name"},
                      Fault{"map.yaml", "image: map.pgm", "image: [", "map.yaml"},
                      Fault{"map.pgm", "P5", "P2", "P5"}, Fault{"map.pgm", "3 2", "3 3", "size"},
                      Fault{"map.pgm", "3 2", "999999999999 2", "too large"},
                      Fault{"map.pgm", "3 2", "900000 900000", "size"},
                      Fault{"map.pgm", "3 2", "0 2", "0"}, Fault{"map.pgm", "255", "256", "255"}));

TEST(MapFilesOfNothing, AreRefused) {
  EXPECT_THROW(map_files(GridMapper(GridOptions{}), PixelMode::trinary), std::runtime_error);
}

}  // namespace
}  // namespace portolan
