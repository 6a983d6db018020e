// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/pose_graph_node.hpp"

#include <algorithm>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/params.hpp"

namespace portolan {

namespace {

constexpr double kPollPeriod = 0.05;  // [s]

GraphNodeOptions read(const ros::NodeHandle& private_handle) {
  GraphNodeOptions options;
  read_parameters(private_handle, options);
  return options;
}

Time now() { return ros_convert::time(ros::Time::now()); }

std::size_t count(const Graph& graph, ArcKind kind, ArcState state) {
  const auto is_one = [&](const Arc& arc) { return arc.kind == kind && arc.state == state; };
  return static_cast<std::size_t>(std::count_if(graph.arcs().begin(), graph.arcs().end(), is_one));
}

}  // namespace

PoseGraphNode::PoseGraphNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : handle_(handle), private_handle_(private_handle), options_(read(private_handle)) {
  subscribe();
  diagnostics_.setHardwareID("none");
  diagnostics_.add("mapping", [this](auto& status) { this->fill(status); });
  const auto every = [this](double period, const auto& deed) {
    timers_.push_back(handle_.createWallTimer(
        ros::WallDuration(period), [deed](const ros::WallTimerEvent& /*event*/) { deed(); }));
  };
  every(kPollPeriod, [this] { pipeline_.poll(now()); });
  every(options_.node.publish_interval, [this] {
    outputs_.publish(ros::Time::now());
    say_what_was_dropped();
  });
  every(options_.node.diagnostic_period, [this] { diagnostics_.force_update(); });
}

void PoseGraphNode::subscribe() {
  subscriptions_.add_poses(options_.node.odom_topic, pipeline_, &now);
  for (const std::string& topic : options_.scan_topics) {
    subscriptions_.add<sensor_msgs::LaserScan>(
        topic, options_.posing.queue_size,
        [this](const sensor_msgs::LaserScan& message) { pipeline_.receive_scan(message, now()); });
  }
  if (options_.initial_pose_topic.empty()) return;
  constexpr int kQueue = 10;
  subscriptions_.add<geometry_msgs::PoseWithCovarianceStamped>(
      options_.initial_pose_topic, kQueue,
      [this](const geometry_msgs::PoseWithCovarianceStamped& message) {
        pipeline_.receive_initial_pose(message, now());
      });
}

void PoseGraphNode::fill(diagnostic_updater::DiagnosticStatusWrapper& status) {
  diagnosis_.fill(pipeline_.posed().tallies(), status);
  const PoseGraph& graph = pipeline_.graph();
  status.add("keyframes", graph.keyframes().size());
  status.add("keyframes dropped", graph.dropped());
  status.add("keyframes without scan", graph.forgotten());
  status.add("loops accepted", count(graph.graph(), ArcKind::loop, ArcState::accepted));
  status.add("loops rejected",
             count(graph.graph(), ArcKind::loop, ArcState::rejected) + graph.dropped_loops());
  status.add("place known", graph.is_lost() ? "no: until a loop is found" : "yes");
  for (std::size_t i = 0; i < enum_names(InitialPoseFate{}).size(); ++i) {
    const std::size_t poses = pipeline_.initial_poses().count(static_cast<InitialPoseFate>(i));
    if (poses > 0)
      status.add(std::string("initial poses: ") + enum_names(InitialPoseFate{}).at(i), poses);
  }
  status.add("doubts", graph.report() ? to_string(graph.report()->doubts) : "none");
  status.add("transforms refused", pipeline_.posed().bad_transforms());
  status.add("times the clock ran back", pipeline_.time_jumps());
}

void PoseGraphNode::say_what_was_dropped() {
  const std::size_t dropped = pipeline_.graph().dropped();
  if (dropped > dropped_) {
    ROS_INFO("the graph was full: %zu keyframes are dropped, and the others numbered anew",
             dropped - dropped_);
  }
  dropped_ = dropped;
}

std::string PoseGraphNode::map_name() const {
  return string_parameter(private_handle_, "map_name", options_.node.map_name);
}

}  // namespace portolan
