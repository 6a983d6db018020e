// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <stdexcept>

#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/graph_optimizer.hpp"
#include "portolan/graph/spanning_tree.hpp"
#include "portolan_ros/graph/graph_picture.hpp"
#include "portolan_ros/report.hpp"

namespace {

portolan::Graph accepted_of(const portolan::Graph& graph) {
  portolan::Graph accepted(graph.space());
  for (const portolan::GraphPose& pose : graph.poses()) accepted.add(pose);
  for (const portolan::Arc& arc : graph.arcs()) {
    if (arc.state == portolan::ArcState::accepted) accepted.add(arc);
  }
  return accepted;
}

constexpr const char* kUsage =
    "usage: draw_graph IN.g2o FOLDER\n"
    "Draws a pose graph twice: NAME_tree.png with the coordinates of its spanning tree, and\n"
    "NAME_consistent.png with those that contradict its arcs least.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 2, 2, kUsage)) return *code;
  const std::filesystem::path in = argv[1];
  const std::string name = in.stem();
  portolan::Graph graph = accepted_of(portolan::load_graph(in));
  if (graph.poses().empty()) throw std::runtime_error(in.string() + ": no poses");
  portolan::place_along(portolan::spanning_tree(graph), graph);
  portolan::FileSet pictures;
  pictures[name + "_tree.png"] = portolan::graph_picture(graph);
  portolan::GraphOptimizer().optimize(graph);
  pictures[name + "_consistent.png"] = portolan::graph_picture(graph);
  std::filesystem::create_directories(argv[2]);
  portolan::save_files(argv[2], pictures);
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
