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
      path_(handle, "path", 0.0,
            [this] {
              return stamped(ros_convert::path(source_.graph().graph(), options_.node.map_frame));
            }),
      graph_(handle, "pose_graph", 0.0,
             [this] {
               return stamped(ros_convert::pose_graph(source_.graph(), options_.node.map_frame));
             }),
      markers_(handle, "pose_graph_vis", 0.0, [this] {
        return ros_convert::graph_markers(source_.graph().graph(), options_.node.map_frame);
      }) {
  if (options.output.publish_tf) tf_.emplace(options.node.map_frame, options.posing.odom_frame);
}

void GraphOutputs::publish(const ros::Time& stamp) {
  publish_drift(stamp);
  stamp_ = stamp;
  // From 1, so that an empty graph is published too. Arcs come without moving what is there.
  const PoseGraph& graph = source_.graph();
  const std::uint64_t revision = 1 + graph.generation() + graph.graph().arcs().size();
  path_.publish({source_.restarts(), revision});
  graph_.publish({source_.restarts(), revision});
  markers_.publish({source_.restarts(), revision});
}

void GraphOutputs::publish_drift(const ros::Time& stamp) {
  const Correction correction = source_.graph().correction();
  const Version version{source_.restarts(), source_.graph().generation()};
  if (version == sent_version_ && !drift_changed(correction) && !is_settled(correction)) return;
  portolan_msgs::DriftCorrection message =
      ros_convert::correction(correction, options_.node.map_frame, options_.posing.odom_frame);
  message.header.stamp = stamp;
  correction_.publish(message);
  sent_ = correction;
  sent_version_ = version;
  if (tf_) tf_->set(last_of(sent_));
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

template <class Message>
Message GraphOutputs::stamped(Message message) const {
  message.header.stamp = stamp_;
  return message;
}

}  // namespace portolan
