// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan::bench {

/// A pose graph with a name, its poses as odometry has them.
struct GraphWorkload {
  std::string name;
  Graph graph;
};

/// Streets at right angles and a sphere, of the sizes that the literature likes, and the g2o files
/// that PORTOLAN_POSE_GRAPHS names, separated by colons. Throws std::runtime_error, with the path,
/// for a file that cannot be read or holds no graph.
std::vector<GraphWorkload> graph_workloads();

}  // namespace portolan::bench
