// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/pose_graph_file.hpp"

#include <stdexcept>
#include <vector>

#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/scan_file.hpp"

namespace portolan {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

std::string content(const FileSet& files, const std::string& name) {
  const auto file = files.find(name);
  return file == files.end() ? "" : file->second;
}

// Does it, and says where it was when that throws.
template <class Deed>
auto in(const std::string& place, Deed deed) try {
  return deed();
} catch (const std::exception& error) {
  throw std::runtime_error(place + error.what());
}

}  // namespace

FileSet pose_graph_files(const PoseGraph& graph, const std::string& name) {
  FileSet files = graph_files(graph.graph(), name);
  files[name + ".scans"] = to_scan_file(graph.keyframes());
  return files;
}

PoseGraph pose_graph_from(const PoseGraph::Options& options, const FileSet& files,
                          const std::string& name) {
  const std::string g2o = name + ".g2o";
  const std::string scans = name + ".scans";
  PoseGraph loaded = in(g2o + ": ", [&] {
    const Graph graph = graph_from_g2o(files.at(g2o), content(files, name + ".stamps"));
    if (graph.poses().empty()) throw std::runtime_error("there is no pose in it");
    return PoseGraph::restored(options, graph);
  });
  if (files.count(scans) > 0) {
    in(scans + ": ", [&] { loaded.recall(scans_from_file(files.at(scans))); });
  }
  return loaded;
}

PoseGraph load_pose_graph(const PoseGraph::Options& options, const std::filesystem::path& folder,
                          const std::string& name) {
  std::vector<std::string> names = {name + ".g2o"};
  for (const char* kind : {".stamps", ".scans"}) {
    if (std::filesystem::exists(folder / (name + kind))) names.push_back(name + kind);
  }
  const FileSet files = load_files(folder, names, kMaxBytes);
  return in(folder.string() + "/", [&] { return pose_graph_from(options, files, name); });
}

}  // namespace portolan
