// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <portolan_msgs/PoseGraph.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "portolan/graph/pose_graph.hpp"

namespace portolan::ros_convert {

/// The graph as a message, without a stamp.
portolan_msgs::PoseGraph pose_graph(const PoseGraph& graph, const std::string& map_frame);

/// The arc of this index.
portolan_msgs::GraphArc graph_arc(const Graph& graph, std::size_t index);

/// Where the robot was at each keyframe, without a stamp for the whole.
nav_msgs::Path path(const Graph& graph, const std::string& map_frame);

/// Arcs as lines, each kind in its colour: odometry grey, scan green, loop blue, given orange; what
/// is rejected red and what is disabled dark. Keyframes as dots.
visualization_msgs::MarkerArray graph_markers(const Graph& graph, const std::string& map_frame);

}  // namespace portolan::ros_convert
