// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>

#include "portolan/graph/pose_graph.hpp"
#include "portolan_ros/clock_guard.hpp"
#include "portolan_ros/graph/graph_node_options.hpp"
#include "portolan_ros/graph/initial_poses.hpp"

namespace portolan {

/// From messages to a pose graph. It knows no ROS graph and asks no clock, so a live node and a bag
/// go the same way. When the clock runs back, the graph starts anew.
class GraphPipeline {
 public:
  /// Throws OptionsError.
  explicit GraphPipeline(const GraphNodeOptions& options);
  GraphPipeline(const GraphPipeline&) = delete;  // messages that wait call back into this object
  GraphPipeline& operator=(const GraphPipeline&) = delete;

  void receive_scan(const sensor_msgs::LaserScan& message, Time now);
  void receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now);
  void receive_odometry(const nav_msgs::Odometry& message, Time now);
  void receive_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message, Time now);
  void poll(Time now);

  PoseGraph& graph() { return graph_; }
  const PoseGraph& graph() const { return graph_; }
  /// Another graph takes the place of the one before.
  void restart_from(PoseGraph graph);
  void reset() { restart_from(PoseGraph(options_.graph)); }

  /// Counts the times that it did; with `PoseGraph::generation` it tells old poses from new ones.
  std::size_t restarts() const { return restarts_; }
  std::size_t time_jumps() const { return time_jumps_; }
  const PosedInput& posed() const { return posed_; }
  const InitialPoses& initial_poses() const { return initial_poses_; }

 private:
  void check_clock(Time now);
  void check_transforms();

  GraphNodeOptions options_;
  PosedInput posed_;
  std::size_t scans_;  // the input's number
  PoseGraph graph_;
  InitialPoses initial_poses_{options_.node.map_frame};
  ClockGuard clock_{seconds(0.1)};
  std::size_t restarts_ = 0;
  std::size_t time_jumps_ = 0;
};

}  // namespace portolan
