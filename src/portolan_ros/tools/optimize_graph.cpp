// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <filesystem>
#include <iostream>

#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/graph_optimizer.hpp"
#include "portolan_ros/report.hpp"

namespace {

using Seconds = std::chrono::duration<double>;

void save(const portolan::Graph& graph, const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  portolan::save_files(folder, {{path.filename(), portolan::to_g2o(graph)}});
}

constexpr const char* kUsage =
    "usage: optimize_graph IN.g2o [OUT.g2o]\n"
    "Moves the poses of a graph to where its arcs agree best. Exits with 2 where it doubts the "
    "result,\n"
    "which is written all the same.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 1, 2, kUsage)) return *code;
  portolan::Graph graph = portolan::load_graph(argv[1]);
  const auto start = std::chrono::steady_clock::now();
  const portolan::OptimizerReport report = portolan::GraphOptimizer().optimize(graph);
  const Seconds time = std::chrono::steady_clock::now() - start;
  std::cout << "poses: " << graph.poses().size() << "\narcs: " << graph.arcs().size()
            << "\nchi2_before: " << report.chi2_before << "\nchi2: " << report.chi2
            << "\ndegrees_of_freedom: " << report.degrees_of_freedom
            << "\niterations: " << report.iterations << "\nmilliseconds: " << 1e3 * time.count()
            << "\ndoubts: " << portolan::to_string(report.doubts) << "\n";
  if (argc == 3) save(graph, argv[2]);
  return report.doubts.empty() ? 0 : 2;
} catch (const std::exception& error) {
  return portolan::report(error);
}
