// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/spanning_tree.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace portolan {
namespace {

constexpr std::size_t kNone = SpanningTree::kNone;

Graph poses(std::initializer_list<PoseId> ids) {
  Graph graph;
  for (const PoseId id : ids) {
    GraphPose pose;
    pose.id = id;
    graph.add(pose);
  }
  return graph;
}

Arc arc(PoseId from, PoseId to, double stddev, const Pose& T_from_to = Pose::Identity()) {
  Arc made;
  made.from = from;
  made.to = to;
  made.T_from_to = T_from_to;
  made.information /= stddev * stddev;
  return made;
}

TEST(SpanningTree, takes_the_surest_way_and_not_the_shortest) {
  Graph graph = poses({0, 1, 2});
  graph.add(arc(0, 2, 1.0));
  graph.add(arc(0, 1, 0.1));
  graph.add(arc(2, 1, 0.1));
  const SpanningTree tree = spanning_tree(graph);
  EXPECT_EQ(tree.order, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(tree.arc_to, (std::vector<std::size_t>{kNone, 1, 2}));
  EXPECT_EQ(tree.parent, (std::vector<std::size_t>{kNone, 0, 1}));
  EXPECT_EQ(tree.components, 1U);
}

TEST(SpanningTree, uses_accepted_arcs_only) {
  Graph graph = poses({0, 1});
  graph.add(arc(0, 1, 0.1));
  graph.set_state(0, ArcState::disabled, ArcReason::by_request);
  EXPECT_EQ(spanning_tree(graph).components, 2U);
}

TEST(SpanningTree, grows_from_fixed_poses_and_from_the_lowest_id_of_other_parts) {
  Graph graph = poses({0, 1, 2, 3, 4});
  graph.add(arc(0, 1, 0.1));
  graph.add(arc(2, 3, 0.1));
  graph.add(arc(3, 4, 0.1));
  graph.fix(1, true);
  const SpanningTree tree = spanning_tree(graph);
  EXPECT_EQ(tree.components, 2U);
  EXPECT_EQ(tree.component, (std::vector<std::size_t>{0, 0, 1, 1, 1}));
  EXPECT_EQ(tree.parent, (std::vector<std::size_t>{1, kNone, kNone, 2, 3}));
}

TEST(SpanningTree, joins_parts_that_fixed_poses_hold) {
  Graph graph = poses({0, 1, 2});
  graph.add(arc(0, 1, 1.0));
  graph.add(arc(2, 1, 0.5));
  graph.fix(0, true);
  graph.fix(2, true);
  const SpanningTree tree = spanning_tree(graph);
  EXPECT_EQ(tree.parent[1], 2U);
  EXPECT_EQ(tree.components, 2U);
}

TEST(SpanningTree, counts_a_direction_that_an_arc_leaves_open_as_uncertain) {
  Graph graph = poses({0, 1, 2});
  Arc corridor = arc(0, 2, 0.01);
  corridor.information(0, 0) = 0.0;
  graph.add(corridor);
  graph.add(arc(0, 1, 1.0));
  graph.add(arc(1, 2, 1.0));
  EXPECT_EQ(spanning_tree(graph).parent[2], 1U);
}

TEST(SpanningTree, places_poses_along_arcs_either_way) {
  Graph graph = poses({0, 1, 2});
  graph.move(0, planar_pose(1.0, 0.0, M_PI / 2));
  graph.add(arc(0, 1, 0.1, planar_pose(2.0, 0.0, M_PI / 2)));
  graph.add(arc(2, 1, 0.1, planar_pose(3.0, 0.0, 0.0)));
  place_along(spanning_tree(graph), graph);
  EXPECT_TRUE(graph.at(0).T_map_pose.isApprox(planar_pose(1.0, 0.0, M_PI / 2)));
  EXPECT_TRUE(graph.at(1).T_map_pose.isApprox(planar_pose(1.0, 2.0, M_PI)));
  EXPECT_TRUE(graph.at(2).T_map_pose.isApprox(planar_pose(4.0, 2.0, M_PI)));
}

}  // namespace
}  // namespace portolan
