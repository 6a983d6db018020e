// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovariance.h>
#include <nav_msgs/Path.h>
#include <portolan_msgs/PoseGraph.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
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

/// A pose in the plane that somebody gives by hand. The message's covariance is along the axes of
/// its frame; zeros say nothing, and then it is that of rviz's "2D Pose Estimate". None where it is
/// no pose, or its covariance no covariance.
std::optional<UncertainPose> guess(const geometry_msgs::PoseWithCovariance& message);

/// Arcs as lines, each kind in its colour: odometry grey, scan green, loop blue, given orange; what
/// is rejected red and what is disabled dark. Keyframes as dots. At each loop that can be taken out
/// stands its index, in the namespace `indices`. They replace all markers before them.
visualization_msgs::MarkerArray graph_markers(const Graph& graph, const std::string& map_frame);

}  // namespace portolan::ros_convert
