// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/pose_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {
namespace {

// Three keyframes in a row, and an arc that was refused.
PoseGraph short_graph() {
  PoseGraph graph(PoseGraph::Options{});
  RangeScan scan;
  scan.angle_increment = 0.1;
  scan.range_max = 10.0;
  scan.ranges.assign(20, 20.0F);
  for (int i = 0; i < 3; ++i) {
    graph.insert(Time{seconds(10 + i)}, planar_pose(i, 0.0, 0.0), scan, Pose::Identity());
  }
  graph.add(0, 2, planar_pose(9.0, 0.0, 0.0), 1e4 * TangentMatrix::Identity(), false);
  return graph;
}

TEST(PoseGraphMessage, HoldsPosesAndArcs) {
  const auto message = ros_convert::pose_graph(short_graph(), "map");
  EXPECT_EQ(message.header.frame_id, "map");
  ASSERT_EQ(message.poses.size(), 3U);
  EXPECT_EQ(message.poses[2].id, 2);
  EXPECT_EQ(message.poses[2].stamp, ros::Time(12.0));
  EXPECT_DOUBLE_EQ(message.poses[2].pose.position.x, 2.0);
  ASSERT_EQ(message.arcs.size(), 3U);
  const portolan_msgs::GraphArc& refused = message.arcs[2];
  EXPECT_EQ(refused.index, 2U);
  EXPECT_EQ(refused.kind, portolan_msgs::GraphArc::GIVEN);
  EXPECT_EQ(refused.state, portolan_msgs::GraphArc::REJECTED);
  EXPECT_EQ(refused.reason, "inconsistent");
  EXPECT_DOUBLE_EQ(refused.information[35], 1e4);
  EXPECT_EQ(message.doubts, "none");
}

TEST(PoseGraphMessage, PathIsThatOfTheKeyframes) {
  const nav_msgs::Path path = ros_convert::path(short_graph().graph(), "map");
  ASSERT_EQ(path.poses.size(), 3U);
  EXPECT_EQ(path.poses[1].header.stamp, ros::Time(11.0));
  EXPECT_DOUBLE_EQ(path.poses[1].pose.position.x, 1.0);
}

TEST(PoseGraphMessage, MarkersTellKindsOfArcsApart) {
  const auto markers = ros_convert::graph_markers(short_graph().graph(), "map");
  const auto points = [&](const std::string& name) {
    const auto found = std::find_if(markers.markers.begin(), markers.markers.end(),
                                    [&](const auto& marker) { return marker.ns == name; });
    return found == markers.markers.end() ? 0 : found->points.size();
  };
  EXPECT_EQ(points("odometry"), 4U);
  EXPECT_EQ(points("rejected"), 2U);
  EXPECT_EQ(points("loop"), 0U);
  EXPECT_EQ(points("keyframes"), 3U);
  EXPECT_EQ(markers.markers.front().action, visualization_msgs::Marker::DELETEALL);
}

TEST(PoseGraphMessage, MarkersNameTheArcsThatCanBeTakenOut) {
  const auto indices = [](const PoseGraph& graph) {
    std::vector<std::string> all;
    for (const auto& marker : ros_convert::graph_markers(graph.graph(), "map").markers) {
      if (marker.ns == "indices") all.push_back(marker.text);
    }
    return all;
  };
  PoseGraph graph = short_graph();
  EXPECT_EQ(indices(graph), std::vector<std::string>{});
  graph.enable(2);
  EXPECT_EQ(indices(graph), std::vector<std::string>{"2"});
  graph.disable(2);
  EXPECT_EQ(indices(graph), std::vector<std::string>{});
}

}  // namespace
}  // namespace portolan
