// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/options.hpp"

namespace portolan::sim {

/// Parameters of the node beside those of the simulation.
struct RobotSimOptions {
  std::string world_file;
  double wall_height = 2.5;
  double real_time_factor = 1.0;
  bool publish_clock = true;
  bool stop_at_end = true;
  std::vector<std::string> wait_for_subscribers;
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string frame_prefix;
  std::string truth_directory;
  double truth_resolution = 0.05;
  double truth_height = 0.2;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("world_file", self.world_file,
          "world as YAML, ours or map_server's; takes the place of world");
    visit("wall_height", self.wall_height, "of what a map_server file shows [m]", above(0.0));
    visit("real_time_factor", self.real_time_factor,
          "simulated time per real time; 0: as fast as it can", at_least(0.0));
    visit("publish_clock", self.publish_clock,
          "makes /clock; else follows it, as a second robot must");
    visit("stop_at_end", self.stop_at_end, "time stands still half a second after the path's end");
    visit("wait_for_subscribers", self.wait_for_subscribers,
          "topics that someone must listen to before time begins; as many as it is named times");
    visit("map_frame", self.map_frame, "of ground_truth");
    visit("odom_frame", self.odom_frame, "of odom");
    visit("base_frame", self.base_frame, "of the robot");
    visit("frame_prefix", self.frame_prefix, "before every frame but the map's, such as robot1/");
    visit("truth_directory", self.truth_directory, "folder for the truth as files; empty: none");
    visit("truth_resolution", self.truth_resolution, "side of a cell of the true grid [m]",
          above(0.0));
    visit("truth_height", self.truth_height, "at which the true grid cuts the world [m]");
  }
};

}  // namespace portolan::sim
