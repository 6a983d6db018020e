// SPDX-License-Identifier: BSD-3-Clause
// A pose graph's g2o, stamps and scans, and what the node makes of them.
#include "fuzz.hpp"
#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/pose_graph_file.hpp"
#include "portolan/graph/scan_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const std::vector<std::string> parts = fuzz::split(data, size);
  FileSet files = {{"graph.g2o", parts.front()},
                   {"graph.stamps", parts.size() > 1 ? parts[1] : ""}};
  const auto read = [](const FileSet& set) {
    return graph_from_g2o(set.at("graph.g2o"), set.at("graph.stamps"));
  };
  fuzz::load_and_save(files, read, [](const Graph& graph) { return graph_files(graph, "graph"); });
  if (parts.size() > 2) files["graph.scans"] = parts[2];
  const PoseGraph::Options options;
  fuzz::load_and_save(
      files, [&](const FileSet& set) { return pose_graph_from(options, set, "graph"); },
      [&](const PoseGraph& graph) {
        FileSet again = files;  // coordinates that are solved anew may differ in their last digit
        again["graph.scans"] = to_scan_file(graph.keyframes());
        return again;
      });
  return 0;
}
