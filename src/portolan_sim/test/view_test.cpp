// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

/// A room of 1 m with a block of 0.2 m to the right of the sensor, which stands at 0.3, 0.5.
WorldOptions room_with_block(Material material) {
  WorldOptions options = room(1.0);
  options.floor = false;
  WorldOptions::Box block;
  block.center = {0.6, 0.5};
  block.size = {0.2, 0.2};
  block.material = material;
  options.boxes.push_back(block);
  return options;
}

std::string seen_by(const AnySensor& sensor, Material material) {
  const World world(room_with_block(material));
  View view(truth_grid(world, 0.1, 0.2, {0.3, 0.5}));
  view.look(world, sensor, planar_pose(0.3, 0.5, 0.0));
  return to_text(view.grid());
}

AnySensor laser() {
  Laser::Options options;
  options.position = {0.0, 0.0, 0.2};
  return Laser(options, 0);
}

TEST(View, ALaserSeesAllButWhatIsInShadow) {
  EXPECT_EQ(seen_by(laser(), Material::ordinary),
            "                \n"
            "                \n"
            "   ##########   \n"
            "  #..........#  \n"
            "  #..........#  \n"
            "  #.........    \n"
            "  #.......      \n"
            "  #.....#       \n"
            "  #.....#       \n"
            "  #.......      \n"
            "  #.........    \n"
            "  #..........#  \n"
            "  #..........#  \n"
            "   ##########   \n"
            "                \n"
            "                \n");
}

TEST(View, GlassHidesNothingFromALaser) {
  const std::string seen = seen_by(laser(), Material::glass);
  EXPECT_NE(seen.find("#..........#"), std::string::npos);
  EXPECT_EQ(seen.find(".#."), std::string::npos);
}

TEST(View, ASonarSeesItsConeUpToTheFirstEcho) {
  SonarRing::Options options;
  options.angles = {0.0};
  options.radius = 0.0;
  options.aperture = 1.2;
  const std::string seen = seen_by(SonarRing(options, 0), Material::ordinary);
  EXPECT_NE(seen.find("..#"), std::string::npos);
  const auto count = [&](char c) { return std::count(seen.begin(), seen.end(), c); };
  EXPECT_EQ(count('#'), 2);
  EXPECT_LT(count('.'), 12);
  EXPECT_GT(count('.'), 3);
}

}  // namespace
}  // namespace portolan::sim
