// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/truth_grid.hpp"

#include <gtest/gtest.h>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

TEST(TruthGrid, DrawsARoomWithABlock) {
  WorldOptions options = room(0.8);
  WorldOptions::Box block;
  block.center = {0.55, 0.35};
  block.size = {0.3, 0.3};
  options.boxes.push_back(block);
  EXPECT_EQ(to_text(truth_grid(World(options), 0.1, 0.2, {0.1, 0.1})),
            "              \n"
            "              \n"
            "  ##########  \n"
            "  #........#  \n"
            "  #........#  \n"
            "  #........#  \n"
            "  #....###.#  \n"
            "  #....###.#  \n"
            "  #....###.#  \n"
            "  #........#  \n"
            "  #........#  \n"
            "  ##########  \n"
            "              \n"
            "              \n");
}

TEST(TruthGrid, CutsTheWorldAtItsHeight) {
  WorldOptions options = room(0.4);
  WorldOptions::Cylinder lamp;
  lamp.center = {0.2, 0.2};
  lamp.radius = 0.1;
  lamp.bottom = 1.0;
  options.cylinders.push_back(lamp);
  const World world(options);
  const auto occupied = [&](double z) {
    return truth_grid(world, 0.1, z, {0.05, 0.05}).at({4, 4}) == TruthGrid::Cell::occupied;
  };
  EXPECT_FALSE(occupied(0.2));
  EXPECT_TRUE(occupied(1.2));
}

TEST(TruthGrid, WhatIsShutOffStaysUnknown) {
  WorldOptions options = room(0.5);
  WorldOptions::Wall wall;
  wall.points = {{0.25, 0.0}, {0.25, 0.5}};
  options.walls.push_back(wall);
  const TruthGrid grid = truth_grid(World(options), 0.1, 0.2, {0.05, 0.05});
  EXPECT_EQ(grid.at(grid.cell_of({0.15, 0.35})), TruthGrid::Cell::free);
  EXPECT_EQ(grid.at(grid.cell_of({0.25, 0.35})), TruthGrid::Cell::occupied);
  EXPECT_EQ(grid.at(grid.cell_of({0.45, 0.35})), TruthGrid::Cell::unknown);
}

TEST(TruthGrid, LiesWhereItsPictureSays) {
  const TruthGrid grid = truth_grid(World(room(1.0)), 0.05, 0.2, {0.5, 0.5});
  EXPECT_NEAR(grid.origin.x(), -0.2, 1e-12);
  EXPECT_EQ(grid.width, 28);
  const MapPicture picture = to_picture(grid);
  EXPECT_EQ(picture.resolution, 0.05);
  EXPECT_EQ(picture.rect.min.x, -4);
  EXPECT_EQ(picture.rect.width(), grid.width);
  EXPECT_EQ(picture.rect.height(), grid.height);
}

}  // namespace
}  // namespace portolan::sim
