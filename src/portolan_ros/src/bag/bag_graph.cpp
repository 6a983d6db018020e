// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/bag_graph.hpp"

#include <utility>

#include "portolan_ros/bag/tally_summary.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/graph/graph_keeper.hpp"
#include "portolan_ros/graph/graph_picture.hpp"

namespace portolan {

BagGraph::BagGraph(const GraphNodeOptions& options) : options_(checked(options)) {
  const auto on_tf = [this](bool is_static) {
    return [this, is_static](const rosbag::MessageInstance& instance, Time now) {
      const auto message = instance.instantiate<tf2_msgs::TFMessage>();
      if (!message) return;
      trajectory_.receive_tf(*message);
      pipeline_.receive_tf(*message, is_static, now);
    };
  };
  handle("tf", on_tf(false));
  handle("tf_static", on_tf(true));
  if (!options_.odom_topic.empty()) {
    handle(options_.odom_topic, [this](const rosbag::MessageInstance& instance, Time now) {
      const auto message = instance.instantiate<nav_msgs::Odometry>();
      if (!message) return;
      trajectory_.receive_odometry(*message);
      pipeline_.receive_odometry(*message, now);
    });
  }
  for (const std::string& topic : options_.scan_topics) {
    handle(topic, [this](const rosbag::MessageInstance& instance, Time now) {
      const auto message = instance.instantiate<sensor_msgs::LaserScan>();
      if (message) pipeline_.receive_scan(*message, now);
    });
  }
}

void BagGraph::handle(const std::string& topic, Handler handler) {
  handlers_[ros_convert::without_slash(topic)] = std::move(handler);
}

std::set<std::string> BagGraph::topics() const {
  std::set<std::string> names;
  for (const auto& [topic, handler] : handlers_) names.insert(topic);
  return names;
}

std::set<std::string> BagGraph::input_topics() const {
  std::set<std::string> names;
  for (const std::string& topic : options_.scan_topics) {
    names.insert(ros_convert::without_slash(topic));
  }
  return names;
}

void BagGraph::take(const rosbag::MessageInstance& message) {
  const auto found = handlers_.find(ros_convert::without_slash(message.getTopic()));
  if (found == handlers_.end()) return;
  const auto start = std::chrono::steady_clock::now();
  newest_ = ros_convert::time(message.getTime());
  found->second(message, newest_);
  wall_time_ += std::chrono::steady_clock::now() - start;
}

void BagGraph::finish() { pipeline_.poll(newest_ + seconds(options_.posing.tf_wait + 1.0)); }

FileSet BagGraph::files() const {
  const PoseGraph& graph = pipeline_.graph();
  FileSet files = graph_file_set(graph, options_.map_name);
  files.erase(options_.map_name + ".tum");
  if (!trajectory_.empty()) files["trajectory.tum"] = trajectory_.tum(correction());
  const std::string picture = graph_picture(graph.graph(), surfaces_of(graph));
  if (!picture.empty()) files[options_.map_name + ".png"] = picture;
  return files;
}

YAML::Node BagGraph::summary() const {
  const PoseGraph& graph = pipeline_.graph();
  YAML::Node node;
  node["inputs"] = counts_of(tallies());
  node["transforms_refused"] = pipeline_.posed().bad_transforms();
  node["keyframes"] = graph.keyframes().size();
  std::map<std::string, std::size_t> arcs;
  for (const Arc& arc : graph.graph().arcs()) {
    const auto name = [](auto value) {
      return std::string(enum_names(value).at(static_cast<std::size_t>(value)));
    };
    ++arcs[name(arc.kind) + " " + name(arc.state) + " " + name(arc.reason)];
  }
  for (const auto& [what, count] : arcs) node["arcs"][what] = count;
  node["doubts"] = graph.report() ? to_string(graph.report()->doubts) : "none";
  node["wall_time"] = wall_time_.count();
  node["options"] = YAML::Load(to_yaml(option_rows(options_)));
  return node;
}

}  // namespace portolan
