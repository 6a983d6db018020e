// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "pairs.hpp"
#include "portolan/graph/match/correlative.hpp"
#include "portolan/graph/match/icp.hpp"
#include "portolan/graph/match/scan_surface.hpp"
#include "workload.hpp"
#ifdef PORTOLAN_BENCH_HAS_MRPT_SLAM
#include "mrpt_icp.hpp"
#endif

namespace portolan::bench {
namespace {

// Two scans, how they truly lie, and a wrong guess.
struct Task {
  const RangeScan* target;
  const RangeScan* source;
  Pose T_target_source;
  Pose T_guess;
};

using Matcher = std::function<Pose(const Task&)>;

Pose match(const Task& task, bool wide) {
  const Surface target = scan_surface(*task.target, {});
  const Surface source = scan_surface(*task.source, {});
  const SurfaceIndex index(target);
  const Match near = icp(index, source, task.T_guess, GraphSpace::planar, {});
  constexpr double kGood = 0.7;
  if (!wide || (near.converged && near.overlap >= kGood)) return near.T_target_source;
  const SearchWindow window{1.2, 0.9};
  const auto far =
      CorrelativeMatcher(target, window.reach, {}).search(source, task.T_guess, window);
  if (!far) return near.T_target_source;
  const Match again = icp(index, source, far->T_target_source, GraphSpace::planar, {});
  return again.overlap > near.overlap ? again.T_target_source : near.T_target_source;
}

// Each of some pairs of neighbouring scans, from guesses that are off by `away` [m] and `turned`
// [rad] in eight ways.
std::vector<Task> tasks(const Workload& load, double away, double turned) {
  std::vector<Task> all;
  constexpr std::size_t kPairs = 12;
  const std::size_t stride = std::max<std::size_t>(1, load.readings.size() / kPairs);
  for (std::size_t i = 0; i + 1 < load.readings.size(); i += stride) {
    const auto& a = load.readings[i];
    const auto& b = load.readings[i + 1];
    const Pose T = a.T_map_sensor.inverse() * b.T_map_sensor;
    for (int way = 0; way < 8; ++way) {
      const double toward = way * M_PI_4;
      const double turn = way % 2 == 0 ? turned : -turned;
      const Pose guess = T * planar_pose(away * std::cos(toward), away * std::sin(toward), turn);
      all.push_back({&std::get<RangeScan>(a.z), &std::get<RangeScan>(b.z), T, guess});
    }
  }
  return all;
}

struct Result {
  double success = 0.0;    // share within 5 cm and 0.5 degrees
  double millimetres = 0;  // mean error of those
};

Result judge(const std::vector<Task>& tasks, const Matcher& matcher) {
  Result result;
  for (const Task& task : tasks) {
    const Pose error = task.T_target_source.inverse() * matcher(task);
    const double distance = error.translation().head<2>().norm();
    if (distance > 0.05 || std::abs(yaw(error)) > 0.5 * M_PI / 180.0) continue;
    result.success += 1.0;
    result.millimetres += 1e3 * distance;
  }
  result.millimetres /= std::max(1.0, result.success);
  result.success /= static_cast<double>(tasks.size());
  return result;
}

void match_scans(benchmark::State& state, const std::vector<Task>& tasks, const Matcher& peer,
                 const Matcher& ours) {
  const auto all = [&tasks](const Matcher& matcher) {
    for (const Task& task : tasks) benchmark::DoNotOptimize(matcher(task));
  };
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(pairs.run([&] { all(peer); }, [&] { all(ours); }));
  }
  const auto count = static_cast<double>(tasks.size());
  const Result of_peer = judge(tasks, peer);
  const Result of_ours = judge(tasks, ours);
  state.counters["us_peer"] = pairs.peer() / count * 1e6;
  state.counters["us_ours"] = pairs.ours() / count * 1e6;
  state.counters["times_faster"] = pairs.ratio();
  state.counters["success_peer"] = of_peer.success;
  state.counters["success_ours"] = of_ours.success;
  state.counters["mm_peer"] = of_peer.millimetres;
  state.counters["mm_ours"] = of_ours.millimetres;
}

std::map<std::string, Matcher> peers() {
  std::map<std::string, Matcher> all = {
      {"ours_near", [](const Task& task) { return match(task, false); }}};
#ifdef PORTOLAN_BENCH_HAS_MRPT_SLAM
  for (const bool tuned : {false, true}) {
    all[tuned ? "mrpt_tuned" : "mrpt"] = [tuned](const Task& task) {
      return mrpt_icp(*task.target, *task.source, task.T_guess, tuned);
    };
  }
#endif
  return all;
}

const bool kMatchesRegistered = [] {
  const Matcher ours = [](const Task& task) { return match(task, true); };
  for (const Workload& load : workloads()) {
    for (const auto& [away, degrees] :
         {std::pair{0.0, 0.0}, {0.25, 10.0}, {0.5, 20.0}, {1.0, 45.0}}) {
      const std::string off = std::to_string(static_cast<int>(100.0 * away)) + "cm_" +
                              std::to_string(static_cast<int>(degrees)) + "deg";
      for (const auto& [name, peer] : peers()) {
        const auto run = [&load, away = away, turned = degrees * M_PI / 180.0, peer = peer,
                          ours](benchmark::State& state) {
          match_scans(state, tasks(load, away, turned), peer, ours);
        };
        benchmark::RegisterBenchmark(("match/" + load.name + "/" + off + "/" + name).c_str(), run)
            ->UseManualTime()
            ->Iterations(3);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace portolan::bench
