// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_keeper.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/pose_graph_file.hpp"
#include "portolan_ros/map_services.hpp"

namespace portolan {

FileSet graph_file_set(const PoseGraph& graph, const std::string& name) {
  if (graph.keyframes().empty()) return {};
  FileSet files = pose_graph_files(graph, name);
  files[name + ".tum"] = to_tum(graph.graph());
  return files;
}

std::string GraphKeeper::save(const std::string& name) {
  return keep_files(options_.node.map_directory,
                    graph_file_set(pipeline_.graph(), checked_map_name(name)));
}

std::string GraphKeeper::load(const std::string& name) {
  const std::filesystem::path folder = folder_of(options_.node.map_directory);
  PoseGraph graph = load_pose_graph(options_.graph, folder, checked_map_name(name));
  const std::string found = std::to_string(graph.keyframes().size() - graph.forgotten());
  const std::string what = "loaded " + (folder / (name + ".g2o")).string() + " and the scans of " +
                           found + " of " + std::to_string(graph.keyframes().size()) + " keyframes";
  pipeline_.restart_from(std::move(graph));
  return what;
}

std::string GraphKeeper::reset() {
  pipeline_.reset();
  return "the graph is empty";
}

}  // namespace portolan
