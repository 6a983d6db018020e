// SPDX-License-Identifier: BSD-3-Clause
#include "graph_workload.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "portolan/graph/g2o_file.hpp"
#include "portolan/testing/graph_worlds.hpp"

namespace portolan::bench {

std::vector<GraphWorkload> graph_workloads() {
  std::vector<GraphWorkload> all = {
      {"streets_3500", testing::streets(3500, 20).graph()},
      {"city_10000", testing::streets(10000, 40).graph()},
      {"corridors_15000", testing::roads(15000, 6, 60, 7).graph()},
      {"rooms_1700", testing::roads(1700, 2, 30, 2).graph()},
      {"roads_4500", testing::roads(4500, 4, 200, 12, {0.05, 0.006}).graph()},
      {"sphere_2500", testing::sphere(50, 50, {0.05, 0.01}).graph()},
      {"torus_5000", testing::torus(100, 50, {0.1, 0.1}).graph()}};
  const char* files = std::getenv("PORTOLAN_POSE_GRAPHS");
  std::istringstream paths(files == nullptr ? "" : files);
  for (std::string path; std::getline(paths, path, ':');) {
    Graph graph = load_graph(path);
    if (graph.poses().empty()) throw std::runtime_error(path + ": holds no poses");
    all.push_back({std::filesystem::path(path).stem().string(), std::move(graph)});
  }
  return all;
}

}  // namespace portolan::bench
