// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/map_file.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How a node that draws maps stands in its ROS graph: the same for every kind of map.
struct NodeOptions {
  std::string map_frame = "map";
  std::string odom_topic;
  std::string map_directory = "~/.ros/portolan";
  std::string map_name = "map";
  double publish_interval = 0.5;
  double diagnostic_period = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("map_frame", self.map_frame, "frame of the published map");
    visit("odom_topic", self.odom_topic,
          "topic of nav_msgs/Odometry, for robots that send no tf; empty: use tf");
    visit("map_directory", self.map_directory, "the only folder that ~save and ~load touch");
    visit("map_name", self.map_name, "bare name of the files that ~save and ~load use");
    visit("publish_interval", self.publish_interval, "least time between publications [s]",
          within(0.05, 3600.0));
    visit("diagnostic_period", self.diagnostic_period, "time between diagnostics [s]",
          within(0.05, 60.0));
    visit.require(!self.map_frame.empty(), "map_frame must not be empty");
    visit.require(!self.map_directory.empty(), "map_directory must not be empty");
    visit.require(is_bare_name(self.map_name),
                  "map_name must be a bare file name, without folders: they are map_directory's");
  }
};

/// A node's options before anybody changed them: its files are named after the kind of map, so that
/// several nodes can share a folder.
inline NodeOptions node_options_for(const std::string& map_name) {
  NodeOptions options;
  options.map_name = map_name;
  return options;
}

}  // namespace portolan
