// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

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

/// The different cells that a reading updates, in the mean.
double cells_per_reading(const Workload& load) {
  std::size_t cells = 0;
  for (const Workload::Reading& reading : load.readings) {
    GridMapper map(our_options(load.max_range, Margin::none));
    map.insert(reading.z, reading.T_map_sensor);
    for (std::int8_t p : map.occupancy(map.bounds())) cells += p >= 0 ? 1 : 0;
  }
  return static_cast<double>(cells) / static_cast<double>(load.readings.size());
}

void draw(benchmark::State& state, const Workload& load, const MakeDrawer& make_peer) {
  Drawer peer = make_peer(load);
  Drawer ours = our_grid(load, Margin::none);
  const auto pass = [&load](Drawer& drawer) {
    for (std::size_t i = 0; i < load.readings.size(); ++i) drawer(i);
  };
  pass(peer);  // warm: all of both maps is there
  pass(ours);
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(pairs.run([&] { pass(peer); }, [&] { pass(ours); }));
  }
  const auto count = static_cast<double>(load.readings.size());
  state.counters["us_peer"] = pairs.peer() / count * 1e6;
  state.counters["us_ours"] = pairs.ours() / count * 1e6;
  state.counters["times_faster"] = pairs.ratio();
  state.counters["ns_per_cell"] = pairs.ours() / (count * cells_per_reading(load)) * 1e9;
}

void add(const std::string& name, const Workload& load, const MakeDrawer& make_peer, int times) {
  const auto run = [&load, make_peer](benchmark::State& state) { draw(state, load, make_peer); };
  benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime()->Iterations(times);
}

const bool kRegistered = [] {
  for (const Workload& load : workloads()) {
    for (const auto& [name, make] : peers())
      add("grid_scan/" + load.name + "/" + name, load, make, 15);
  }
#ifdef PORTOLAN_BENCH_HAS_MRPT
  static const std::vector<Workload> kPings = [] {
    std::vector<Workload> loads;
    for (const bool on_the_way : {false, true}) {
      for (const double range : {1.0, 2.0, 4.0}) loads.push_back(pings(range, on_the_way));
    }
    return loads;
  }();
  const auto mrpt = [](const Workload& load) { return mrpt_grid(load, false); };
  for (const Workload& load : kPings) add("grid_sonar/" + load.name, load, mrpt, 51);
#endif
  return true;
}();

}  // namespace
}  // namespace portolan::bench

BENCHMARK_MAIN();
