// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "graph/match/flat_world.hpp"
#include "portolan/graph/pose_graph.hpp"

namespace portolan {

/// Corridors round a block of 16 by 10 metres, with doors and niches.
inline FlatWorld office() {
  FlatWorld world;
  world.box(0, 0, 16, 10).box(2, 2, 14, 8).box(4.0, 2.0, 5.0, 2.4).box(9.3, 1.6, 10.1, 2.0);
  world.box(0.0, 5.0, 0.5, 6.2).box(13.6, 4.1, 14.0, 5.0).box(6.5, 9.6, 7.1, 10.0);
  return world.box(11.0, 8.0, 11.6, 8.3).box(15.5, 6.5, 16.0, 7.1).box(3.0, 0.0, 3.6, 0.3);
}

/// The middle of the corridors, by way from the start [m]; rounds of 44 metres.
inline Pose on_the_round(double way) {
  const double sides[] = {14.0, 8.0, 14.0, 8.0};
  Pose T = planar_pose(1.0, 1.0, 0.0);
  double left = std::fmod(way, 44.0);
  for (const double side : sides) {
    if (left <= side) return T * planar_pose(left, 0.0, 0.0);
    T = T * planar_pose(side, 0.0, M_PI_2);
    left -= side;
  }
  return T;
}

/// A robot on its rounds, what it made of them, and where it truly was at each keyframe.
struct Drive {
  PoseGraph graph{PoseGraph::Options{}};
  std::vector<Pose> truth;
  Pose T_odom = Pose::Identity();
  std::mt19937_64 random{1};
};

/// Drives so far with odometry that turns too much.
inline void go_on(Drive& run, double from, double to) {
  const FlatWorld world = office();
  Pose last = on_the_round(from);
  for (double way = from; way <= to; way += 0.1) {
    const Pose now = on_the_round(way);
    Pose step = last.inverse() * now;
    step = step * planar_pose(0.0, 0.0, 0.0006);
    run.T_odom = run.T_odom * step;
    last = now;
    const RangeScan scan = world.scan(now, 180, 0.01, run.random);
    const Time stamp{seconds(10.0 + way)};
    if (run.graph.insert(stamp, run.T_odom, scan, Pose::Identity()) == Outcome::inserted) {
      run.truth.push_back(now);
    }
  }
}

/// The same with a new graph.
inline void drive(Drive& run, double from, double to, const PoseGraph::Options& options = {}) {
  run = Drive{};
  run.graph = PoseGraph(options);
  go_on(run, from, to);
}

inline PoseGraph::Options odometry_only() {
  PoseGraph::Options options;
  options.scans.enabled = false;
  return options;
}

inline std::size_t count(const PoseGraph& graph, ArcKind kind, ArcState state) {
  const auto& arcs = graph.graph().arcs();
  return static_cast<std::size_t>(std::count_if(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    return arc.kind == kind && arc.state == state;
  }));
}

}  // namespace portolan
