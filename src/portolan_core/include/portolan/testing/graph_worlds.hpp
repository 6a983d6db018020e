// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>

#include "portolan/testing/graph_walk.hpp"

namespace portolan::testing {

namespace graph_worlds_detail {

constexpr std::array<std::pair<int, int>, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

using Visits = std::map<std::pair<int, int>, std::size_t>;

// Measures the last pose from the one that was here before, if that is long enough ago.
inline void recognise(GraphWalk& walk, Visits& visits, const std::pair<int, int>& place,
                      std::size_t ago) {
  const std::size_t last = walk.size() - 1;
  const auto [visit, is_new] = visits.try_emplace(place, last);
  if (!is_new && visit->second + ago < last) walk.measure(visit->second, last);
  visit->second = last;
}

/// Who walks a square of `reach` steps each way, and turns back at its rim.
struct Walker {
  int reach;
  std::pair<int, int> place{0, 0};
  std::size_t heading = 0;  // of kSteps

  Pose pose() const {
    return planar_pose(place.first, place.second, M_PI_2 * static_cast<double>(heading));
  }

  /// By so many quarters to the left, and on until the next step stays inside.
  void turn(std::size_t quarters) {
    heading = (heading + quarters) % 4;
    while (std::abs(place.first + kSteps[heading].first) > reach ||
           std::abs(place.second + kSteps[heading].second) > reach) {
      heading = (heading + 1) % 4;
    }
  }

  void go_on() {
    place.first += kSteps[heading].first;
    place.second += kSteps[heading].second;
  }
};

}  // namespace graph_worlds_detail

/// Streets between square blocks, `side` of them each way: every crossing that was visited before
/// is recognised, as in the Manhattan worlds and the cities of the literature.
inline GraphWalk streets(std::size_t poses, int side, const GraphNoise& noise = {}) {
  GraphWalk walk(GraphSpace::planar, noise);
  std::mt19937_64 random(3);
  graph_worlds_detail::Visits visits;
  graph_worlds_detail::Walker walker{side};
  while (walk.size() < poses) {
    walk.go_to(walker.pose());
    graph_worlds_detail::recognise(walk, visits, walker.place, 1);
    walker.turn(random() % 3 == 0 ? 1 + 2 * (random() % 2) : 0);
    walker.go_on();
  }
  return walk;
}

/// A route along the streets of a town in steps of a metre, `block` of them from crossing to
/// crossing: long ways between few recognised places, of which one in `rarity` is used.
inline GraphWalk roads(std::size_t poses, int side, int block, std::size_t rarity,
                       const GraphNoise& noise = {}) {
  GraphWalk walk(GraphSpace::planar, noise);
  std::mt19937_64 random(5);
  graph_worlds_detail::Visits visits;
  graph_worlds_detail::Walker walker{side * block};
  while (walk.size() < poses) {
    if (walker.place.first % block == 0 && walker.place.second % block == 0) {
      const std::size_t turn = random() % 3;  // ahead, left, right
      walker.turn(turn == 2 ? 3 : turn);
    }
    walk.go_to(walker.pose());
    if (random() % rarity == 0) graph_worlds_detail::recognise(walk, visits, walker.place, 50);
    walker.go_on();
  }
  return walk;
}

/// Laps up a sphere of 50 m, each pose seen again from the lap above.
inline GraphWalk sphere(std::size_t laps, std::size_t lap, const GraphNoise& noise = {}) {
  GraphWalk walk(GraphSpace::spatial, noise);
  for (std::size_t i = 0; i < laps * lap; ++i) {
    const double around = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(lap);
    const double up = M_PI * (static_cast<double>(i) / static_cast<double>(laps * lap) - 0.5);
    walk.go_to(Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(-up, Eigen::Vector3d::UnitY()) *
               Eigen::Translation3d(50.0, 0.0, 0.0));
    if (i >= lap) walk.measure(i - lap, i);
  }
  return walk;
}

/// A coil of `laps` round the tube of a torus, whose end meets its beginning: no pose is near the
/// root, and turns add up all the way.
inline GraphWalk torus(std::size_t laps, std::size_t lap, const GraphNoise& noise = {}) {
  GraphWalk walk(GraphSpace::spatial, noise);
  const std::size_t poses = laps * lap;
  for (std::size_t i = 0; i < poses; ++i) {
    const double along = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(poses);
    const double around = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(lap);
    walk.go_to(Eigen::AngleAxisd(along, Eigen::Vector3d::UnitZ()) *
               Eigen::Translation3d(0.2 * static_cast<double>(laps), 0.0, 0.0) *
               Eigen::AngleAxisd(around, Eigen::Vector3d::UnitY()) *
               Eigen::Translation3d(0.16 * static_cast<double>(lap), 0.0, 0.0));
    if (i >= lap) walk.measure(i - lap, i);
  }
  for (std::size_t i = 0; i < lap; ++i) walk.measure(poses - lap + i, i);
  return walk;
}

}  // namespace portolan::testing
