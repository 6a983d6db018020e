// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <string>

#include "../nodes/robot_sim_options.hpp"
#include "portolan/sim/simulation_options.hpp"
#include "portolan_ros/options_page.hpp"
#include "portolan_ros/report.hpp"

namespace {

/// What each item of a list of sensors may hold.
template <class Sensor>
void add_section(const std::string& list) {
  std::cout << portolan::page_section("robot_sim: each of " + list,
                                      portolan::option_rows(typename Sensor::Options{}));
}

constexpr const char* kUsage =
    "usage: robot_sim_docs CONFIG_FOLDER > page.md\n"
    "Writes the simulated robot's YAML file of defaults into a folder, and its table to stdout.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 1, 1, kUsage)) return *code;
  using namespace portolan::sim;
  portolan::document(argv[1], "robot_sim",
                     portolan::option_rows(RobotSimOptions{}, SimulationOptions{}));
  add_section<Laser>("lasers");
  add_section<SonarRing>("sonar_rings");
  add_section<Lidar>("lidars");
  add_section<DepthCamera>("depth_cameras");
  add_section<LandmarkSensor>("landmark_sensors");
  add_section<Camera>("cameras");
  add_section<BeaconReceiver>("beacon_receivers");
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
