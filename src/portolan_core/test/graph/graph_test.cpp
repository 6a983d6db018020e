// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace portolan {
namespace {

GraphPose pose(PoseId id) {
  GraphPose made;
  made.id = id;
  return made;
}

Arc arc(PoseId from, PoseId to) {
  Arc made;
  made.from = from;
  made.to = to;
  return made;
}

Graph two_poses(GraphSpace space = GraphSpace::planar) {
  Graph graph(space);
  graph.add(pose(7));
  graph.add(pose(-3));
  return graph;
}

TEST(Graph, keeps_poses_by_id) {
  const Graph graph = two_poses();
  ASSERT_EQ(graph.poses().size(), 2U);
  EXPECT_EQ(graph.poses()[0].id, -3);
  EXPECT_EQ(graph.find(7), 1U);
  EXPECT_EQ(graph.at(7).id, 7);
  EXPECT_FALSE(graph.find(0));
  EXPECT_THROW(graph.at(0), std::out_of_range);
}

TEST(Graph, refuses_what_makes_no_sense) {
  Graph graph = two_poses();
  EXPECT_THROW(graph.add(pose(7)), std::invalid_argument);
  EXPECT_THROW(graph.add(arc(7, 7)), std::invalid_argument);
  EXPECT_THROW(graph.add(arc(7, 8)), std::invalid_argument);
  GraphPose bent = pose(1);
  bent.T_map_pose(0, 0) = 2.0;
  EXPECT_THROW(graph.add(bent), std::invalid_argument);
  Arc torn = arc(7, -3);
  torn.T_from_to(0, 3) = std::nan("");
  EXPECT_THROW(graph.add(torn), std::invalid_argument);
  EXPECT_EQ(graph.poses().size(), 2U);
  EXPECT_TRUE(graph.arcs().empty());
}

TEST(Graph, rejects_arcs_whose_information_is_none) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, inf, std::nan("")}) {
    Graph graph = two_poses(GraphSpace::spatial);
    Arc doubtful = arc(7, -3);
    doubtful.information(4, 4) = bad;
    const std::size_t index = graph.add(doubtful);
    EXPECT_EQ(graph.arcs()[index].state, ArcState::rejected) << bad;
    EXPECT_EQ(graph.arcs()[index].reason, ArcReason::bad_information) << bad;
  }
  Graph graph = two_poses(GraphSpace::spatial);
  Arc lopsided = arc(7, -3);
  lopsided.information(0, 1) = 0.5;
  graph.add(lopsided);
  EXPECT_EQ(graph.arcs()[0].reason, ArcReason::bad_information);
}

TEST(Graph, accepts_information_about_some_directions_only) {
  Graph graph = two_poses();
  Arc known_in_x = arc(7, -3);
  known_in_x.information.setZero();
  known_in_x.information(0, 0) = 4.0;
  known_in_x.information(3, 3) = -1.0;  // does not count in the plane
  graph.add(known_in_x);
  EXPECT_EQ(graph.arcs()[0].state, ArcState::accepted);
}

TEST(Graph, changes_the_state_of_arcs) {
  Graph graph = two_poses();
  const std::size_t index = graph.add(arc(7, -3));
  graph.set_state(index, ArcState::disabled, ArcReason::by_request);
  EXPECT_EQ(graph.arcs()[index].state, ArcState::disabled);
  EXPECT_EQ(graph.arcs()[index].reason, ArcReason::by_request);
  EXPECT_THROW(graph.set_state(1, ArcState::accepted, ArcReason::none), std::out_of_range);
}

}  // namespace
}  // namespace portolan
