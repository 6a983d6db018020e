// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/bag_graph.hpp"

#include <utility>

#include "portolan_ros/bag/tally_summary.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/correction.hpp"
#include "portolan_ros/graph/graph_keeper.hpp"
#include "portolan_ros/graph/graph_picture.hpp"

namespace portolan {

BagGraph::BagGraph(const GraphNodeOptions& options) : options_(checked(options)) {
  topics_.add_poses(options_.node.odom_topic, trajectory_, pipeline_);
  for (const std::string& topic : options_.scan_topics) {
    topics_.add<sensor_msgs::LaserScan>(topic,
                                        [this](const sensor_msgs::LaserScan& message, Time now) {
                                          pipeline_.receive_scan(message, now);
                                        });
  }
  if (options_.initial_pose_topic.empty()) return;
  topics_.add<geometry_msgs::PoseWithCovarianceStamped>(
      options_.initial_pose_topic,
      [this](const geometry_msgs::PoseWithCovarianceStamped& message, Time now) {
        pipeline_.receive_initial_pose(message, now);
      });
}

std::set<std::string> BagGraph::input_topics() const {
  std::set<std::string> names;
  for (const std::string& topic : options_.scan_topics) {
    names.insert(ros_convert::without_slash(topic));
  }
  return names;
}

void BagGraph::finish() {
  pipeline_.poll(topics_.newest() + seconds(options_.posing.tf_wait + 1.0));
}

Correction BagGraph::correction() const {
  const std::string& map_frame = options_.node.map_frame;
  const std::string& odom_frame = options_.posing.odom_frame;
  const Correction exact = pipeline_.graph().correction();
  return ros_convert::correction(ros_convert::correction(exact, map_frame, odom_frame), map_frame,
                                 odom_frame);
}

FileSet BagGraph::files() const {
  const PoseGraph& graph = pipeline_.graph();
  FileSet files = graph_file_set(graph, options_.node.map_name);
  files.erase(options_.node.map_name + ".tum");
  if (!trajectory_.empty()) files["trajectory.tum"] = trajectory_.tum(correction());
  const std::string picture = graph_picture(graph.graph(), surfaces_of(graph));
  if (!picture.empty()) files[options_.node.map_name + ".png"] = picture;
  return files;
}

YAML::Node BagGraph::summary() const {
  const PoseGraph& graph = pipeline_.graph();
  YAML::Node node;
  node["inputs"] = counts_of(tallies());
  node["transforms_refused"] = pipeline_.posed().bad_transforms();
  node["keyframes"] = graph.keyframes().size();
  node["keyframes_dropped"] = graph.dropped();
  std::map<std::string, std::size_t> arcs;
  for (const Arc& arc : graph.graph().arcs()) {
    const auto name = [](auto value) {
      return std::string(enum_names(value).at(static_cast<std::size_t>(value)));
    };
    ++arcs[name(arc.kind) + " " + name(arc.state) + " " + name(arc.reason)];
  }
  for (const auto& [what, count] : arcs) node["arcs"][what] = count;
  node["doubts"] = graph.report() ? to_string(graph.report()->doubts) : "none";
  node["wall_time"] = topics_.wall_time();
  node["options"] = YAML::Load(to_yaml(option_rows(options_)));
  return node;
}

}  // namespace portolan
