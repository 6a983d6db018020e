// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_keeper.hpp"

#include <filesystem>
#include <stdexcept>

#include "portolan/graph/g2o_file.hpp"
#include "portolan_ros/map_services.hpp"

namespace portolan {

FileSet graph_file_set(const PoseGraph& graph, const std::string& name) {
  if (graph.keyframes().empty()) return {};
  FileSet files = graph_files(graph.graph(), name);
  files[name + ".tum"] = to_tum(graph.graph());
  return files;
}

std::string GraphKeeper::save(const std::string& name) {
  return keep_files(options_.node.map_directory,
                    graph_file_set(pipeline_.graph(), checked_map_name(name)));
}

std::string GraphKeeper::load(const std::string& name) {
  const std::filesystem::path file =
      folder_of(options_.node.map_directory) / (checked_map_name(name) + ".g2o");
  const Graph graph = load_graph(file);
  if (graph.poses().empty()) throw std::runtime_error(file.string() + ": there is no pose in it");
  try {
    pipeline_.restart_from(PoseGraph::restored(options_.graph, graph));
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
  return "loaded " + file.string();
}

std::string GraphKeeper::reset() {
  pipeline_.reset();
  return "the graph is empty";
}

}  // namespace portolan
