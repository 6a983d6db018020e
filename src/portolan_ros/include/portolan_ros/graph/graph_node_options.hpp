// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/graph/pose_graph_options.hpp"
#include "portolan_ros/posed_input.hpp"

namespace portolan {

/// What of the graph leaves its node, and when.
struct GraphOutputOptions {
  bool publish_tf = true;
  double min_shift = 0.05;
  double min_turn = 0.01;
  double settle_after = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("publish_tf", self.publish_tf, "send map_frame to odom_frame on /tf");
    visit("min_shift", self.min_shift,
          "without a loop, a correction is sent once the drift has changed so far [m]",
          at_least(0.0));
    visit("min_turn", self.min_turn, "or turned so far [rad]", at_least(0.0));
    visit("settle_after", self.settle_after,
          "or once no keyframe has come for so long in real time, whatever has changed [s]",
          at_least(0.0));
  }
};

/// All options of the pose graph's node, as its private parameters name them.
struct GraphNodeOptions {
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  std::string odom_topic;
  std::vector<std::string> scan_topics = {"scan"};
  std::string map_directory = "~/.ros/portolan";
  std::string map_name = "pose_graph";
  double publish_interval = 0.5;
  double diagnostic_period = 1.0;
  PosedInputOptions posing;
  GraphOutputOptions output;
  PoseGraphOptions graph;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("map_frame", self.map_frame, "frame of the corrected poses");
    visit("base_frame", self.base_frame, "the robot's own frame");
    visit("odom_topic", self.odom_topic,
          "topic of nav_msgs/Odometry, for robots that send no tf; empty: use tf");
    visit("scan_topics", self.scan_topics, "topics of sensor_msgs/LaserScan");
    visit("map_directory", self.map_directory, "the only folder that ~save and ~load touch");
    visit("map_name", self.map_name, "bare name of the files that ~save and ~load use");
    visit("publish_interval", self.publish_interval, "least time between publications [s]",
          within(0.05, 3600.0));
    visit("diagnostic_period", self.diagnostic_period, "time between diagnostics [s]",
          within(0.05, 60.0));
    PosedInputOptions::describe(self.posing, visit);
    GraphOutputOptions::describe(self.output, visit);
    PoseGraphOptions::describe(self.graph, visit);
  }
};

}  // namespace portolan
