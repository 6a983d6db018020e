// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/pose_graph_file.hpp"

#include <gtest/gtest.h>

#include "graph/round_drive.hpp"
#include "map_file_fixture.hpp"

namespace portolan {
namespace {

constexpr double kHalt = 40.0;  // way at which the graph is saved [m]

const Drive& until_the_halt() {
  static const Drive kRun = [] {
    Drive made;
    drive(made, 0.0, kHalt, odometry_only());
    return made;
  }();
  return kRun;
}

class PoseGraphFile : public MapFileTest {
 protected:
  PoseGraphFile() { save_files(folder, pose_graph_files(until_the_halt().graph, "graph")); }

  PoseGraph loaded(const PoseGraph::Options& options = odometry_only()) const {
    return load_pose_graph(options, folder, "graph");
  }
  std::string fault() const {
    return message_of([&] { loaded(); });
  }
};

// Loops from keyframes of before the halt to such of after it, and how far they are wrong.
struct Bridges {
  std::size_t count = 0;
  double worst = 0.0;  // [m]
};

Bridges bridges(const Drive& run) {
  const auto old = static_cast<PoseId>(until_the_halt().truth.size());
  Bridges found;
  for (const Arc& arc : run.graph.graph().arcs()) {
    const bool is_loop = arc.kind == ArcKind::loop && arc.state == ArcState::accepted;
    if (!is_loop || arc.from >= old || arc.to < old) continue;
    const auto at = [&](PoseId id) { return run.truth[static_cast<std::size_t>(id)]; };
    const Pose error = arc.T_from_to.inverse() * (at(arc.from).inverse() * at(arc.to));
    found.worst = std::max(found.worst, error.translation().norm());
    ++found.count;
  }
  return found;
}

TEST_F(PoseGraphFile, is_the_same_once_loaded_and_saved) {
  const FileSet before = pose_graph_files(until_the_halt().graph, "graph");
  const FileSet after = pose_graph_files(loaded(), "graph");
  EXPECT_TRUE(after.at("graph.scans") == before.at("graph.scans"));
  EXPECT_TRUE(after.at("graph.stamps") == before.at("graph.stamps"));
  save_files(folder, after);
  EXPECT_TRUE(pose_graph_files(loaded(), "graph") == after);
}

TEST_F(PoseGraphFile, finds_its_places_again_after_a_restart) {
  Drive run = until_the_halt();
  run.graph = loaded();
  EXPECT_EQ(run.graph.forgotten(), 0U);
  go_on(run, kHalt, kHalt + 30.0);
  const Bridges found = bridges(run);
  EXPECT_GT(found.count, 3U);
  EXPECT_LT(found.worst, 0.25);  // of maps that odometry alone has bent
}

// The robot is switched on again a step beside and turned, and its wheels count from there on.
TEST_F(PoseGraphFile, finds_its_places_again_with_other_odometry) {
  Drive run = until_the_halt();
  run.graph = loaded();
  run.T_odom = run.T_odom * planar_pose(-0.8, 0.6, 0.3);
  go_on(run, kHalt, kHalt + 40.0);
  const Bridges found = bridges(run);
  EXPECT_GT(found.count, 3U);
  EXPECT_LT(found.worst, 0.25);  // of maps that odometry alone has bent
}

// The robot is switched off and on where it stands, and its wheels begin to count anew.
TEST_F(PoseGraphFile, knows_where_it_stands_when_odometry_begins_anew) {
  const PoseGraph::Options options;
  Drive run;
  drive(run, 0.0, kHalt, options);
  save_files(folder, pose_graph_files(run.graph, "graph"));
  const std::size_t halt = run.truth.size();
  run.graph = loaded(options);
  run.T_odom = planar_pose(-50.0, 80.0, 2.5);
  go_on(run, kHalt, kHalt + 2.0);
  const auto& poses = run.graph.graph().poses();
  ASSERT_GT(run.truth.size(), halt);
  const Pose T_last_next = poses[halt - 1].T_map_pose.inverse() * poses[halt].T_map_pose;
  const Pose truth = run.truth[halt - 1].inverse() * run.truth[halt];
  EXPECT_LT((truth.inverse() * T_last_next).translation().norm(), 0.05);
  EXPECT_EQ(count(run.graph, ArcKind::scan, ArcState::rejected), 0U);
}

TEST_F(PoseGraphFile, loads_a_graph_without_scans) {
  fs::remove(folder / "graph.scans");
  Drive run = until_the_halt();
  run.graph = loaded();
  EXPECT_EQ(run.graph.forgotten(), until_the_halt().truth.size());
  go_on(run, kHalt, kHalt + 30.0);
  EXPECT_EQ(bridges(run).count, 0U);
}

TEST_F(PoseGraphFile, keeps_no_more_scans_than_the_budget_allows) {
  PoseGraph::Options options = odometry_only();
  options.keyframes.scan_budget = 0.02;
  const PoseGraph graph = loaded(options);
  EXPECT_GT(graph.forgotten(), 20U);
  EXPECT_LT(graph.forgotten(), graph.keyframes().size());
  EXPECT_TRUE(graph.keyframes().front().scan.ranges.empty());
  EXPECT_FALSE(graph.keyframes().back().scan.ranges.empty());
}

TEST_F(PoseGraphFile, says_which_file_is_wrong) {
  const std::string scans = pose_graph_files(until_the_halt().graph, "graph").at("graph.scans");
  const std::string count = std::to_string(until_the_halt().truth.size());
  put("graph.scans", scans.substr(0, scans.size() - 1));
  EXPECT_EQ(fault(),
            (folder / "graph.scans").string() + ": scan " + count + " of " + count + " is cut off");
  put("graph.scans", "");
  EXPECT_EQ(fault().find((folder / "graph.scans").string() + ": does not begin with"), 0U);
  put("graph.g2o", "VERTEX_SE2 0\n");
  EXPECT_EQ(fault().find((folder / "graph.g2o").string() + ": line 1:"), 0U);
  put("graph.g2o", "");
  EXPECT_EQ(fault(), (folder / "graph.g2o").string() + ": there is no pose in it");
  fs::remove(folder / "graph.g2o");
  EXPECT_NE(fault().find("graph.g2o"), std::string::npos);
}

TEST_F(PoseGraphFile, refuses_the_scans_of_another_graph) {
  Drive other;
  drive(other, 0.25, kHalt, odometry_only());
  put("graph.scans", pose_graph_files(other.graph, "graph").at("graph.scans"));
  EXPECT_EQ(fault(),
            (folder / "graph.scans").string() + ": there is no keyframe 0 of the scan's time");
}

}  // namespace
}  // namespace portolan
