// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "portolan/graph/graph.hpp"
#include "portolan/graph/pose_graph.hpp"

namespace portolan {

/// Where the keyframes' scans met surfaces, in the map's plane [m].
std::vector<Eigen::Vector2d> surfaces_of(const PoseGraph& graph);

/// The bytes of a PNG file: a graph from above, its arcs coloured by kind and state, over points of
/// the map's plane [m]. Empty for a graph without poses.
std::string graph_picture(const Graph& graph, const std::vector<Eigen::Vector2d>& surfaces = {});

}  // namespace portolan
