// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "beacon_workload.hpp"
#include "pairs.hpp"
#ifdef PORTOLAN_BENCH_HAS_MRPT
#include "mrpt_beacons.hpp"
#endif

namespace portolan::bench {
namespace {

// Poses are known and the device reads true, as the peer takes for granted.
BeaconOptions all_is_known() {
  BeaconOptions options;
  options.drift = 0.0;
  options.calibration.scale_stddev = 0.0;
  options.calibration.bias_stddev = 0.0;
  options.calibration.turn_stddev = 0.0;
  return options;
}

void report_error(benchmark::State& state, const std::string& whose, const BeaconWorkload& load,
                  const Places& places) {
  double sum = 0.0;
  double worst = 0.0;
  for (const auto& [id, truth] : load.truth) {
    const auto found = places.find(id);
    if (found == places.end()) continue;
    const double error = (found->second - truth).head<2>().norm();
    sum += error;
    worst = std::max(worst, error);
  }
  state.counters["error_" + whose] = sum / static_cast<double>(load.truth.size());
  state.counters["worst_" + whose] = worst;
}

void time_beacons(benchmark::State& state, const BeaconWorkload& load) {
#ifdef PORTOLAN_BENCH_HAS_MRPT
  const auto peer = mrpt_beacons(load);
  report_error(state, "peer", load, peer());
#else
  const auto peer = [] { return 0; };
#endif
  const BeaconOptions options = all_is_known();
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(
        pairs.run([&] { benchmark::DoNotOptimize(peer()); },
                  [&] { benchmark::DoNotOptimize(map_beacons(options, load)); }));
  }
  const auto ranges = static_cast<double>(load.ranges());
  report_error(state, "ours", load, places(map_beacons(options, load)));
  state.counters["us_ours"] = pairs.ours() / ranges * 1e6;
#ifdef PORTOLAN_BENCH_HAS_MRPT
  state.counters["us_peer"] = pairs.peer() / ranges * 1e6;
  state.counters["times_faster"] = pairs.ratio();
#endif
}

#ifdef PORTOLAN_BENCH_HAS_MRPT
// The public demonstration log of MRPT with its table of true places, where it is installed.
std::vector<BeaconWorkload> real_logs() {
  const std::string path = "/usr/share/mrpt/datasets/RO-SLAM_demo";
  if (!std::ifstream(path + "_ground_truth.txt")) return {};
  BeaconWorkload load = beacon_rawlog(path + ".rawlog");
  load.name = "ro_slam_demo";
  load.truth = read_places(path + "_ground_truth.txt");
  return {load};
}
#else
std::vector<BeaconWorkload> real_logs() { return {}; }
#endif

const std::vector<BeaconWorkload>& beacon_workloads() {
  static const std::vector<BeaconWorkload> kAll = [] {
    std::vector<BeaconWorkload> loads = real_logs();
    loads.push_back(straight_drive(0.1));
    loads.push_back(loop_drive(0.1));
    return loads;
  }();
  return kAll;
}

const bool kBeaconsRegistered = [] {
  for (const BeaconWorkload& load : beacon_workloads()) {
    benchmark::RegisterBenchmark(("beacons/" + load.name).c_str(),
                                 [&load](benchmark::State& state) { time_beacons(state, load); })
        ->UseManualTime()
        ->Iterations(15);
  }
  return true;
}();

}  // namespace
}  // namespace portolan::bench
