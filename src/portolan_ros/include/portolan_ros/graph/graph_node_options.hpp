// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/graph/pose_graph_options.hpp"
#include "portolan_ros/node_options.hpp"
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
  NodeOptions node = node_options_for("pose_graph");
  std::string base_frame = "base_link";
  std::vector<std::string> scan_topics = {"scan"};
  std::string initial_pose_topic = "initialpose";
  PosedInputOptions posing;
  GraphOutputOptions output;
  PoseGraphOptions graph;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    NodeOptions::describe(self.node, visit);
    visit("base_frame", self.base_frame, "the robot's own frame");
    visit("scan_topics", self.scan_topics, "topics of sensor_msgs/LaserScan");
    visit("initial_pose_topic", self.initial_pose_topic,
          "geometry_msgs/PoseWithCovarianceStamped in which somebody says where the robot was "
          "carried, or where it starts in a graph that was loaded; empty: none");
    PosedInputOptions::describe(self.posing, visit);
    GraphOutputOptions::describe(self.output, visit);
    PoseGraphOptions::describe(self.graph, visit);
    visit.require(!self.base_frame.empty(), "base_frame must not be empty");
    visit.require(
        self.node.map_frame != self.posing.odom_frame,
        "map_frame and odom_frame must be two: the graph says how one drifts in the other");
  }
};

}  // namespace portolan
