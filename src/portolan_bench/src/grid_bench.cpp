// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <string>

#include "bresenham_grid.hpp"
#include "our_grid.hpp"
#include "pairs.hpp"
#include "workload.hpp"
#ifdef PORTOLAN_BENCH_HAS_MRPT
#include "mrpt_grid.hpp"
#endif

namespace portolan::bench {
namespace {

using MakeDrawer = std::function<Drawer(const Workload&)>;

std::map<std::string, MakeDrawer> peers() {
  std::map<std::string, MakeDrawer> peers = {{"bresenham", &bresenham_grid}};
  peers["ours_with_margin"] = [](const Workload& load) {
    return our_grid(load, Margin::by_default);
  };
#ifdef PORTOLAN_BENCH_HAS_MRPT
  peers["mrpt_rays"] = [](const Workload& load) { return mrpt_grid(load, false); };
  peers["mrpt_widening"] = [](const Workload& load) { return mrpt_grid(load, true); };
#endif
  return peers;
}

/// The different cells that a scan updates, in the mean.
double cells_per_scan(const Workload& load) {
  std::size_t cells = 0;
  for (const Workload::PosedScan& posed : load.scans) {
    GridMapper map(our_options(load.max_range, Margin::none));
    map.insert(posed.scan, posed.T_map_sensor);
    for (std::int8_t p : map.occupancy(map.bounds())) cells += p >= 0 ? 1 : 0;
  }
  return static_cast<double>(cells) / static_cast<double>(load.scans.size());
}

void report(benchmark::State& state, const Pairs& pairs, double count, double cells) {
  state.counters["us_peer"] = pairs.peer() / count * 1e6;
  state.counters["us_ours"] = pairs.ours() / count * 1e6;
  state.counters["times_faster"] = pairs.ratio();
  state.counters["ns_per_cell"] = pairs.ours() / (count * cells) * 1e9;
}

void draw_scans(benchmark::State& state, const Workload& load, const MakeDrawer& make_peer) {
  Drawer peer = make_peer(load);
  Drawer ours = our_grid(load, Margin::none);
  const auto pass = [&load](Drawer& drawer) {
    for (std::size_t i = 0; i < load.scans.size(); ++i) drawer.scan(i);
  };
  pass(peer);  // warm: all of both maps is there
  pass(ours);
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(pairs.run([&] { pass(peer); }, [&] { pass(ours); }));
  }
  report(state, pairs, static_cast<double>(load.scans.size()), cells_per_scan(load));
}

#ifdef PORTOLAN_BENCH_HAS_MRPT
void draw_echoes(benchmark::State& state, double range) {
  constexpr int kPings = 1000;
  const Workload none{"none", 5.0, {}};
  const RangeEcho echo{range, 0.02, 10.0, M_PI / 6.0};
  Drawer peer = mrpt_grid(none, false);
  Drawer ours = our_grid(none, Margin::none);
  const auto pass = [&echo](Drawer& drawer) {
    for (int i = 0; i < kPings; ++i) drawer.echo(echo);
  };
  pass(peer);
  pass(ours);
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(pairs.run([&] { pass(peer); }, [&] { pass(ours); }));
  }
  GridMapper one(our_options(5.0, Margin::none));
  one.insert(echo, Pose::Identity());
  int cells = 0;
  for (std::int8_t p : one.occupancy(one.bounds())) cells += p >= 0 ? 1 : 0;
  report(state, pairs, kPings, cells);
}
#endif

const bool kRegistered = [] {
  for (const Workload& load : workloads()) {
    for (const auto& [name, make] : peers()) {
      const auto run = [&load, make = make](benchmark::State& state) {
        draw_scans(state, load, make);
      };
      benchmark::RegisterBenchmark(("grid_scan/" + load.name + "/" + name).c_str(), run)
          ->UseManualTime()
          ->Iterations(15);
    }
  }
#ifdef PORTOLAN_BENCH_HAS_MRPT
  for (const double range : {1.0, 2.0, 4.0}) {
    const auto run = [range](benchmark::State& state) { draw_echoes(state, range); };
    const std::string name = "grid_sonar/30deg_" + std::to_string(static_cast<int>(range)) + "m";
    benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime()->Iterations(51);
  }
#endif
  return true;
}();

}  // namespace
}  // namespace portolan::bench

BENCHMARK_MAIN();
