// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/message_instance.h>
#include <yaml-cpp/yaml.h>

#include <chrono>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "portolan/map_file.hpp"
#include "portolan_ros/bag/trajectory.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"

namespace portolan {

/// The pose graph over a bag: what its node would do, without a ROS graph.
class BagGraph {
 public:
  static constexpr const char* kName = "pose_graph";

  /// Throws OptionsError.
  explicit BagGraph(const GraphNodeOptions& options);

  std::set<std::string> topics() const;
  std::set<std::string> input_topics() const;
  void take(const rosbag::MessageInstance& message);
  /// No more messages come: what still waits for tf is used or dropped.
  void finish();

  /// What all maps are to be bent by.
  Correction correction() const { return pipeline_.graph().correction(); }

  /// The graph's files and picture, and the corrected trajectory; counts, wall time and options.
  FileSet files() const;
  YAML::Node summary() const;
  const std::vector<Tally>& tallies() const { return pipeline_.posed().tallies(); }

 private:
  using Handler = std::function<void(const rosbag::MessageInstance&, Time)>;

  void handle(const std::string& topic, Handler handler);

  GraphNodeOptions options_;
  GraphPipeline pipeline_{options_};
  Trajectory trajectory_{options_.posing.odom_frame, options_.base_frame};
  std::map<std::string, Handler> handlers_;  // by topic without its slash
  Time newest_;
  std::chrono::duration<double> wall_time_{0.0};  // [s]
};

}  // namespace portolan
