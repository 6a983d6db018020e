// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_outputs.hpp"

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/correction.hpp"
#include "portolan_ros/convert/pose_graph.hpp"

namespace portolan {

namespace {

Pose last_of(const Correction& correction) {
  return correction.knots().empty() ? Pose::Identity() : correction.knots().back().T_map_odom;
}

}  // namespace

GraphOutputs::GraphOutputs(ros::NodeHandle& handle, const GraphNodeOptions& options,
                           const GraphPipeline& source)
    : options_(options),
      source_(source),
      correction_(handle.advertise<portolan_msgs::DriftCorrection>("drift_correction", 1, true)),
      path_(handle.advertise<nav_msgs::Path>("path", 1, true)),
      graph_(handle.advertise<portolan_msgs::PoseGraph>("pose_graph", 1, true)),
      markers_(handle.advertise<visualization_msgs::MarkerArray>("pose_graph_vis", 1, true)) {
  if (options.output.publish_tf) tf_.emplace(options.node.map_frame, options.posing.odom_frame);
}

void GraphOutputs::publish(const ros::Time& stamp) {
  const Correction correction = source_.graph().correction();
  const Version version{source_.restarts(), source_.graph().generation()};
  if (version != sent_version_ || drift_changed(correction) || is_settled(correction)) {
    portolan_msgs::DriftCorrection message =
        ros_convert::correction(correction, options_.node.map_frame, options_.posing.odom_frame);
    message.header.stamp = stamp;
    correction_.publish(message);
    sent_ = correction;
    sent_version_ = version;
    if (tf_) tf_->set(last_of(sent_));
  }
  const std::size_t arcs = source_.graph().graph().arcs().size();
  const std::uint32_t listeners =
      path_.getNumSubscribers() + graph_.getNumSubscribers() + markers_.getNumSubscribers();
  const bool is_shown = version == shown_version_ && arcs == shown_arcs_;
  if (!is_shown || listeners > listeners_) publish_visuals(stamp);
  listeners_ = listeners;
  shown_version_ = version;
  shown_arcs_ = arcs;
}

bool GraphOutputs::drift_changed(const Correction& correction) const {
  const Pose change = last_of(sent_).inverse() * last_of(correction);
  return change.translation().norm() > options_.output.min_shift ||
         rotation_angle(change) > options_.output.min_turn;
}

// The robot stands still, or its bag has ended: what was too little to be sent so far comes now, so
// that in the end all maps are those of the whole graph.
bool GraphOutputs::is_settled(const Correction& correction) {
  const ros::WallTime now = ros::WallTime::now();
  if (correction.knots().size() != keyframes_) {
    keyframes_ = correction.knots().size();
    since_ = now;
  }
  const bool is_quiet = (now - since_).toSec() >= options_.output.settle_after;
  return is_quiet && sent_.knots().size() != keyframes_;
}

void GraphOutputs::publish_visuals(const ros::Time& stamp) {
  const PoseGraph& graph = source_.graph();
  if (path_.getNumSubscribers() > 0) {
    nav_msgs::Path message = ros_convert::path(graph.graph(), options_.node.map_frame);
    message.header.stamp = stamp;
    path_.publish(message);
  }
  if (graph_.getNumSubscribers() > 0) {
    portolan_msgs::PoseGraph message = ros_convert::pose_graph(graph, options_.node.map_frame);
    message.header.stamp = stamp;
    graph_.publish(message);
  }
  if (markers_.getNumSubscribers() > 0) {
    markers_.publish(ros_convert::graph_markers(graph.graph(), options_.node.map_frame));
  }
}

}  // namespace portolan
