// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/g2o_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include "graph/random_graph.hpp"
#include "graph/text_numbers.hpp"
#include "map_file_fixture.hpp"
#include "options/comma_locale.hpp"

namespace portolan {
namespace {

const std::string kInformation2 = " 1 0 0 2 0 3";
const std::string kInformation3 = " 1 0 0 0 0 0 2 0 0 0 0 3 0 0 0 4 0 0 5 0 6";

std::string fault(const std::string& g2o, const std::string& stamps = "") {
  try {
    graph_from_g2o(g2o, stamps);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(G2oFile, reads_a_planar_graph_in_any_order) {
  const Graph graph = graph_from_g2o(
      "# a comment\n\n"
      "EDGE_SE2 7 -2 1 2 0.5 1 2 3 14 5 16\r\n"
      "PARAMS_SE2OFFSET 0 0 0 0\n"
      "VERTEX_SE2 7 0 0 0\n"
      "FIX 7\n"
      "\tVERTEX_SE2  -2 1e0 2.5 -1 \n",
      "7 12.000000005\n-2 13.5\n");
  ASSERT_EQ(graph.poses().size(), 2U);
  EXPECT_EQ(graph.space(), GraphSpace::planar);
  EXPECT_TRUE(graph.at(-2).T_map_pose.isApprox(planar_pose(1.0, 2.5, -1.0)));
  EXPECT_EQ(graph.at(7).stamp, Time(seconds(12.0) + Duration(5)));
  EXPECT_TRUE(graph.at(7).fixed);
  EXPECT_FALSE(graph.at(-2).fixed);
  ASSERT_EQ(graph.arcs().size(), 1U);
  const Arc& arc = graph.arcs()[0];
  EXPECT_EQ(arc.from, 7);
  EXPECT_EQ(arc.kind, ArcKind::loop);
  EXPECT_TRUE(arc.T_from_to.isApprox(planar_pose(1.0, 2.0, 0.5)));
  EXPECT_EQ(arc.information(0, 5), 3.0);
  EXPECT_EQ(arc.information(5, 1), 5.0);
  EXPECT_EQ(arc.information(5, 5), 16.0);
}

TEST(G2oFile, reads_a_graph_in_space_and_normalises_quaternions) {
  const Graph graph = graph_from_g2o(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 2 3 0 0 2 2\n"
      "EDGE_SE3:QUAT 0 1 1 2 3 0 0 -5 -5" +
      kInformation3);
  EXPECT_EQ(graph.space(), GraphSpace::spatial);
  EXPECT_NEAR(yaw(graph.at(1).T_map_pose), M_PI_2, 1e-15);
  EXPECT_NEAR(yaw(graph.arcs()[0].T_from_to), M_PI_2, 1e-15);
  EXPECT_EQ(graph.arcs()[0].kind, ArcKind::odometry);
  EXPECT_EQ(graph.arcs()[0].information.diagonal(), (Tangent() << 1, 2, 3, 4, 5, 6).finished());
}

TEST(G2oFile, places_poses_along_the_tree_where_there_are_none) {
  const Graph graph = graph_from_g2o("EDGE_SE2 5 9 1 0 0" + kInformation2 +
                                     "\nEDGE_SE2 9 10 1 0 0" + kInformation2);
  EXPECT_TRUE(graph.at(10).T_map_pose.isApprox(planar_pose(2.0, 0.0, 0.0)));
}

TEST(G2oFile, takes_an_empty_file_for_an_empty_graph) {
  EXPECT_TRUE(graph_from_g2o("").poses().empty());
  EXPECT_EQ(to_g2o(Graph()), "");
}

TEST(G2oFile, rejects_arcs_whose_information_is_none_and_keeps_them) {
  const Graph graph = graph_from_g2o("EDGE_SE2 0 1 1 0 0 -1 0 0 1 0 1\n");
  EXPECT_EQ(graph.arcs()[0].reason, ArcReason::bad_information);
  const Graph again = graph_from_g2o(to_g2o(graph));
  EXPECT_EQ(again.arcs()[0].reason, ArcReason::bad_information);
  EXPECT_EQ(again.arcs()[0].information(0, 0), -1.0);
}

TEST(G2oFile, says_which_line_is_wrong) {
  const std::string good = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";
  const std::string edge = "EDGE_SE2 0 1 1 0 0" + kInformation2 + "\n";
  EXPECT_EQ(fault(good + edge), "none");
  for (const std::string& bad : {std::string("VERTEX_SE2 2 0 0"),
                                 std::string("VERTEX_SE2 2 0 0 0 0"),
                                 std::string("VERTEX_SE2 2 0 0 nan"),
                                 std::string("VERTEX_SE2 2 0 0 inf"),
                                 std::string("VERTEX_SE2 2 0 0 0x"),
                                 std::string("VERTEX_SE2 2 0 0 1,5"),
                                 std::string("VERTEX_SE2 2.0 0 0 0"),
                                 std::string("VERTEX_SE2 99999999999999999999 0 0 0"),
                                 std::string("VERTEX_SE2 1 0 0 0"),
                                 std::string("VERTEX_SE2"),
                                 std::string("VERTEX_XY 2 0 0"),
                                 std::string("EDGE2 0 1 1 0 0") + kInformation2,
                                 std::string("EDGE_SE2 0 1 1 0 0 1 0 0 1 0"),
                                 "EDGE_SE2 0 0 1 0 0" + kInformation2,
                                 "EDGE_SE2 0 8 1 0 0" + kInformation2,
                                 "EDGE_SE2 0 1 1 0 nan" + kInformation2,
                                 std::string("FIX"),
                                 std::string("FIX 8"),
                                 std::string("FIX x"),
                                 std::string("VERTEX_SE3:QUAT 2 0 0 0 0 0 0 1"),
                                 "EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1" + kInformation3,
                                 std::string("# portolan loop"),
                                 std::string("# portolan loop rejected none"),
                                 std::string("# portolan loop good none"),
                                 std::string("# portolan loop accepted none FIX 0"),
                                 std::string("# portolan loop rejected none FIX 0"),
                                 std::string("\0", 1)}) {
    EXPECT_EQ(fault(good + bad + "\n" + edge).substr(0, 7), "line 3:") << bad;
  }
  EXPECT_EQ(fault("VERTEX_SE3:QUAT 2 0 0 0 0 0 0 0").substr(0, 7), "line 1:");
  EXPECT_EQ(fault(good + "# portolan loop accepted none\n").substr(0, 7), "line 3:");
}

TEST(G2oFile, says_which_stamp_is_wrong) {
  EXPECT_EQ(fault("", "0 1.5\n1 0.000000001\n# 2\n"), "none");
  for (const std::string bad : {"1", "x 1", "1 x", "1 1.0000000001", "1 1 1", "0 1", "1 1.5e3"}) {
    EXPECT_EQ(fault("", "0 1.5\n" + bad).substr(0, 15), "stamps, line 2:") << bad;
  }
}

Graph with_every_state(GraphSpace space, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  RandomGraph made;
  made.space = space;
  Graph graph = made.walk(random).graph;
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    if (i % 3 == 0) continue;
    graph.set_state(i, static_cast<ArcState>(random() % 3), static_cast<ArcReason>(random() % 7));
  }
  graph.fix(3, true);
  return graph;
}

TEST(G2oFile, reads_what_it_writes_to_the_same_text) {
  for (const GraphSpace space : {GraphSpace::planar, GraphSpace::spatial}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Graph graph = with_every_state(space, seed);
      const std::string text = to_g2o(graph);
      const Graph read = graph_from_g2o(text);
      EXPECT_TRUE(to_g2o(read) == text) << seed;
      ASSERT_EQ(read.arcs().size(), graph.arcs().size());
      for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
        EXPECT_TRUE(read.arcs()[i].T_from_to.isApprox(graph.arcs()[i].T_from_to, 1e-13));
        EXPECT_EQ(read.arcs()[i].state, graph.arcs()[i].state);
        EXPECT_EQ(read.arcs()[i].reason, graph.arcs()[i].reason);
        EXPECT_EQ(read.arcs()[i].kind, graph.arcs()[i].kind);
        EXPECT_EQ(read.arcs()[i].information(0, 5), graph.arcs()[i].information(0, 5));
      }
      for (std::size_t i = 0; i < graph.poses().size(); ++i) {
        const Pose& written = graph.poses()[i].T_map_pose;
        EXPECT_TRUE(read.poses()[i].T_map_pose.isApprox(written, 1e-13)) << seed;
        EXPECT_EQ(read.poses()[i].fixed, graph.poses()[i].fixed);
      }
    }
  }
}

TEST(G2oFile, writes_quaternions_whose_components_are_nearly_equal_to_the_same_text) {
  for (int decimals = 3; decimals <= 16; ++decimals) {
    for (const double sign : {1.0, -1.0}) {
      const std::string w = to_text(M_SQRT1_2 + sign * std::pow(10.0, -decimals));
      const std::string saved =
          to_g2o(graph_from_g2o("VERTEX_SE3:QUAT 0 0 0 0 0 0 0.7071067811865476 " + w));
      EXPECT_EQ(to_g2o(graph_from_g2o(saved)), saved) << w;
    }
  }
}

TEST(G2oFile, writes_numbers_the_same_in_every_locale) {
  const Graph graph = with_every_state(GraphSpace::spatial, 3);
  const std::string text = to_g2o(graph);
  const CommaLocale commas;
  EXPECT_TRUE(to_g2o(graph) == text);
  EXPECT_TRUE(to_g2o(graph_from_g2o(text)) == text);
}

TEST(G2oFile, writes_a_trajectory_by_stamps) {
  Graph graph;
  for (const PoseId id : {1, 2}) {
    GraphPose pose;
    pose.id = id;
    pose.stamp = Time(seconds(3.25 - static_cast<double>(id)));
    pose.T_map_pose = planar_pose(0.5, static_cast<double>(id), 0.0);
    graph.add(pose);
  }
  EXPECT_EQ(to_tum(graph), "1.250000000 0.5 2 0 0 0 0 1\n2.250000000 0.5 1 0 0 0 0 1\n");
  EXPECT_EQ(stamps_text(graph), "1 2.250000000\n2 1.250000000\n");
}

class G2oFolder : public MapFileTest {};

TEST_F(G2oFolder, saves_and_loads_with_stamps) {
  const Graph graph = with_every_state(GraphSpace::planar, 1);
  save_files(folder, graph_files(graph, "graph"));
  EXPECT_TRUE(graph_files(load_graph(folder / "graph.g2o"), "graph") ==
              graph_files(graph, "graph"));
  put("bad.g2o", "VERTEX_SE2 0\n");
  const std::string fault = message_of([&] { load_graph(folder / "bad.g2o"); });
  EXPECT_EQ(fault.find((folder / "bad.g2o").string() + ": line 1:"), 0U) << fault;
  EXPECT_NE(message_of([&] { load_graph(folder / "none.g2o"); }).find("none.g2o"),
            std::string::npos);
}

}  // namespace
}  // namespace portolan
