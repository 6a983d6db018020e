// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/map_file.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"

namespace portolan {

/// The graph's files: NAME.g2o, NAME.stamps, NAME.scans and NAME.tum; none of an empty graph.
FileSet graph_file_set(const PoseGraph& graph, const std::string& name);

/// Keeps a pose graph in files, and begins again from files. Each says in a sentence what it did,
/// and throws where it can't; then graph and files are as before.
class GraphKeeper {
 public:
  GraphKeeper(GraphPipeline& pipeline, const GraphNodeOptions& options)
      : pipeline_(pipeline), options_(options) {}

  std::string save(const std::string& name);
  /// Goes on from the graph that was saved, which knows its places by their scans.
  std::string load(const std::string& name);
  std::string reset();

 private:
  GraphPipeline& pipeline_;
  const GraphNodeOptions& options_;
};

}  // namespace portolan
