// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/message_instance.h>
#include <yaml-cpp/yaml.h>

#include <set>
#include <string>

#include "portolan/map_file.hpp"
#include "portolan_ros/bag/bag_topics.hpp"
#include "portolan_ros/bag/trajectory.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"

namespace portolan {

/// The pose graph over a bag: what its node would do, without a ROS graph.
class BagGraph {
 public:
  static constexpr const char* kName = "pose_graph";
  static constexpr const char* kLegend =
      "Lines lead from keyframe to keyframe. Green: along the way. Blue: loops. Red: refused, or "
      "disabled. Grey: what the scans met.";

  /// Throws OptionsError.
  explicit BagGraph(const GraphNodeOptions& options);

  std::set<std::string> topics() const { return topics_.names(); }
  std::set<std::string> input_topics() const;
  void take(const rosbag::MessageInstance& message) { topics_.take(message); }
  /// No more messages come: what still waits for tf is used or dropped.
  void finish();

  /// What all maps are to be bent by, to the last bit as it comes out of a message.
  Correction correction() const;

  /// The graph's files and picture, and the corrected trajectory; counts, wall time and options.
  FileSet files() const;
  YAML::Node summary() const;
  const std::vector<Tally>& tallies() const { return pipeline_.posed().tallies(); }

 private:
  GraphNodeOptions options_;
  GraphPipeline pipeline_{options_};
  Trajectory trajectory_{options_.posing.odom_frame, options_.base_frame};
  BagTopics topics_;
};

}  // namespace portolan
