// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <optional>

#include "our_grid.hpp"
#include "pairs.hpp"
#include "portolan/remapper.hpp"
#include "workload.hpp"

namespace portolan::bench {
namespace {

constexpr int kScans = 10000;

/// A correction after 10,000 scans: the whole map drawn anew, beside inserting the same scans.
void rebuild_map(benchmark::State& state) {
  const Workload load = rooms(360, 2.0 * M_PI, 10.0);
  const GridOptions options = our_options(load.max_range, Margin::by_default);
  Remapper<GridMapper> remapper(RemapperOptions{}, options);
  std::vector<GridMapper::Observation> scans;
  for (int i = 0; i < kScans; ++i) {
    const auto& [scan, T_map_sensor] =
        load.readings[static_cast<std::size_t>(i) % load.readings.size()];
    scans.emplace_back(scan);
    remapper.observe(Time(seconds(0.1 * i)), T_map_sensor, scan);
  }
  const auto insert_all = [&] {
    GridMapper map(options);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      map.insert(scans[i], load.readings[i % load.readings.size()].T_map_sensor);
    }
    benchmark::DoNotOptimize(map.revision());
  };
  Pairs pairs;
  double heading = 0.0;
  for (auto _ : state) {
    heading += 0.01;
    state.SetIterationTime(pairs.run(insert_all, [&] {
      remapper.correct(Correction({{Time{}, planar_pose(0.0, 0.0, heading)}}));
      remapper.finish();
    }));
  }
  state.counters["s_insertion"] = pairs.peer();
  state.counters["s_rebuild"] = pairs.ours();
  state.counters["times_insertion"] = 1.0 / pairs.ratio();
}
BENCHMARK(rebuild_map)->Name("grid_rebuild/10000_scans_360b")->UseManualTime()->Iterations(5);

}  // namespace
}  // namespace portolan::bench
