// SPDX-License-Identifier: BSD-3-Clause
// The worlds that come with portolan: they can be read, and their tours can be driven.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "portolan/sim/simulation.hpp"
#include "portolan/sim/world_file.hpp"

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

class Worlds : public ::testing::TestWithParam<std::string> {
 protected:
  WorldOptions world_options =
      read_world(std::string(PORTOLAN_WORLDS) + "/" + GetParam() + ".yaml");
  bool is_small = GetParam() == "box";
};

TEST_P(Worlds, TheTourIsDrivenToItsEndWithRoomToSpare) {
  SimulationOptions options;
  options.world = world_options;
  options.lasers.clear();
  options.sonar_rings.clear();
  options.robot.radius = is_small ? 0.1 : 0.2;
  Simulation simulation(options);
  double nearest = 1.0;
  while (!simulation.path_finished() && simulation.now() < Time{1000s}) {
    simulation.step(50ms);
    const Eigen::Vector3d p_map = simulation.T_map_base().at(simulation.now()).translation();
    nearest = std::min(nearest, simulation.world().clearance(p_map.head<2>(), 1.0, 0.0, 0.4));
    ASSERT_FALSE(simulation.robot().blocked()) << "at " << p_map.transpose();
  }
  EXPECT_TRUE(simulation.path_finished());
  EXPECT_GT(nearest, options.robot.radius + 0.1);
}

TEST_P(Worlds, EveryLandmarkIsSeenFromTheTour) {
  const World world(world_options);
  for (const auto& [id, p_map] : world.landmarks()) {
    EXPECT_GT(world.clearance(p_map.head<2>(), 1.0, p_map.z() - 0.01, p_map.z() + 0.01), 0.01);
    const Eigen::Vector3d& landmark = p_map;
    const bool seen =
        std::any_of(world_options.tour.begin(), world_options.tour.end(), [&](const auto& point) {
          return world.sees({point[0], point[1], 0.5}, landmark);
        });
    EXPECT_TRUE(seen) << "landmark " << id;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Worlds, ::testing::Values("office", "hall", "box"),
                         [](const auto& world) { return world.param; });

}  // namespace
}  // namespace portolan::sim
