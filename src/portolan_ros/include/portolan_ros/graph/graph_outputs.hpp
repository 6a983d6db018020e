// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <portolan_msgs/PoseGraph.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "portolan_ros/graph/drift_tf.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"
#include "portolan_ros/kinds/whole_map_topic.hpp"

namespace portolan {

/// What the pose graph's node sends: the correction, the map frame on tf, and, while somebody
/// listens, path, graph and markers.
class GraphOutputs {
 public:
  GraphOutputs(ros::NodeHandle& handle, const GraphNodeOptions& options,
               const GraphPipeline& source);
  GraphOutputs(const GraphOutputs&) = delete;  // the topics call back into this object
  GraphOutputs& operator=(const GraphOutputs&) = delete;

  /// Sends what changed since the last time.
  void publish(const ros::Time& stamp);

 private:
  using Version = std::pair<std::size_t, std::size_t>;  // restarts, generation

  bool drift_changed(const Correction& correction) const;
  bool is_settled(const Correction& correction);
  void publish_drift(const ros::Time& stamp);
  template <class Message>
  Message stamped(Message message) const;

  GraphNodeOptions options_;
  const GraphPipeline& source_;
  std::optional<DriftTf> tf_;
  ros::Publisher correction_;
  Correction sent_;
  Version sent_version_{0, 0};
  std::size_t keyframes_ = 0;
  ros::WallTime since_;  // when the last of these came
  ros::Time stamp_;
  WholeMapTopic<nav_msgs::Path> path_;
  WholeMapTopic<portolan_msgs::PoseGraph> graph_;
  WholeMapTopic<visualization_msgs::MarkerArray> markers_;
};

}  // namespace portolan
