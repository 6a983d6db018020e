// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "portolan_ros/graph/drift_tf.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"

namespace portolan {

/// What the pose graph's node sends: the correction, the map frame on tf, and, while somebody
/// listens, path, graph and markers.
class GraphOutputs {
 public:
  GraphOutputs(ros::NodeHandle& handle, const GraphNodeOptions& options,
               const GraphPipeline& source);

  /// Sends what changed since the last time.
  void publish(const ros::Time& stamp);

 private:
  using Version = std::pair<std::size_t, std::size_t>;  // restarts, generation

  bool drift_changed(const Correction& correction) const;
  bool is_settled(const Correction& correction);
  void publish_visuals(const ros::Time& stamp);

  GraphNodeOptions options_;
  const GraphPipeline& source_;
  std::optional<DriftTf> tf_;
  ros::Publisher correction_;
  ros::Publisher path_;
  ros::Publisher graph_;
  ros::Publisher markers_;
  Correction sent_;
  Version sent_version_{0, 0};
  std::size_t keyframes_ = 0;
  ros::WallTime since_;  // when the last of these came
  Version shown_version_{0, 0};
  std::size_t shown_arcs_ = 0;
  std::uint32_t listeners_ = 0;
};

}  // namespace portolan
