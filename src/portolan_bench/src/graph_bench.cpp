// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "graph_workload.hpp"
#include "pairs.hpp"
#include "portolan/graph/graph_optimizer.hpp"
#ifdef PORTOLAN_BENCH_HAS_CERES
#include "ceres_graph.hpp"
#endif
#ifdef PORTOLAN_BENCH_HAS_MRPT_GRAPHSLAM
#include "mrpt_graph.hpp"
#endif

namespace portolan::bench {
namespace {

double chi2(Graph graph) { return GraphOptimizer().optimize(graph).chi2_before; }

// Everything, from a graph to a graph: our spanning tree, analysis, second start and doubts too.
void optimize_graph(benchmark::State& state, const Graph& given) {
  Graph ours = given;
  OptimizerReport report;
  const auto optimize = [&] {
    ours = given;
    report = GraphOptimizer().optimize(ours);
  };
  const auto compare = [&](const std::string& name, Graph& peers, const auto& peer, Pairs& pairs) {
    state.SetIterationTime(pairs.run(peer, optimize));
    state.counters["ms_" + name] = 1e3 * pairs.peer();
    state.counters["times_" + name] = pairs.ratio();
    state.counters["chi2_" + name] = chi2(peers);
    state.counters["ms_ours"] = 1e3 * pairs.ours();
  };
  Pairs ceres_pairs;
  Pairs mrpt_pairs;
  Graph ceres = given;
  Graph mrpt = given;
#ifdef PORTOLAN_BENCH_HAS_MRPT_GRAPHSLAM
  const auto mrpt_optimize = mrpt_optimizer(given, mrpt);
#endif
  for (auto _ : state) {
    Pairs alone;
    state.SetIterationTime(alone.run([] {}, optimize));
    state.counters["ms_ours"] = 1e3 * alone.ours();
#ifdef PORTOLAN_BENCH_HAS_CERES
    const auto ceres_optimize = [&] {
      ceres = given;
      optimize_with_ceres(ceres);
    };
    compare("ceres", ceres, ceres_optimize, ceres_pairs);
#endif
#ifdef PORTOLAN_BENCH_HAS_MRPT_GRAPHSLAM
    compare("mrpt", mrpt, mrpt_optimize, mrpt_pairs);
#endif
  }
  state.counters["chi2_ours"] = report.chi2;
  state.counters["doubts"] = static_cast<double>(report.doubts.size());
}

std::vector<GraphWorkload> workloads_or_exit() try {
  return graph_workloads();
} catch (const std::exception& error) {
  std::cerr << "PORTOLAN_POSE_GRAPHS: " << error.what() << std::endl;
  std::exit(EXIT_FAILURE);
}

const bool kGraphsRegistered = [] {
  for (const GraphWorkload& load : workloads_or_exit()) {
    benchmark::RegisterBenchmark(
        ("graph/" + load.name).c_str(),
        [graph = load.graph](benchmark::State& state) { optimize_graph(state, graph); })
        ->UseManualTime()
        ->Iterations(3)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace portolan::bench
