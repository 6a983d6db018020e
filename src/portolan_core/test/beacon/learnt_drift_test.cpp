// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {
namespace {

using beacon_test::antenna_at;
using beacon_test::Dice;

const std::map<BeaconId, Eigen::Vector3d> kBeacons = {
    {1, {0.0, 0.0, 0.0}}, {2, {6.5, 0.0, 0.0}}, {3, {6.5, 4.5, 0.0}}};
constexpr double kStep = 0.3;  // about, between messages [m]

// To and fro through the room between the beacons.
Eigen::Vector3d on_the_way(int step) {
  const double s = kStep * step;
  return {3.5 + 2.5 * std::sin(0.4 * s), 4.0 + 3.0 * std::sin(0.25 * s + 1.0), 0.0};
}

BeaconRanges ranges_from(const Eigen::Vector3d& antenna, double stddev, Dice& dice) {
  BeaconRanges z;
  for (const auto& [id, place] : kBeacons) {
    z.ranges.push_back({id, (place - antenna).norm() + dice.normal(stddev), stddev});
  }
  return z;
}

// Stray poses: a random walk that adds `drift` [m] per root of the way.
double learnt(double drift, std::uint32_t seed) {
  Dice dice(seed);
  BeaconMapper mapper(BeaconOptions{});
  Eigen::Vector3d astray = Eigen::Vector3d::Zero();
  for (int step = 0; step < 800; ++step) {
    const Eigen::Vector3d antenna = on_the_way(step);
    const double moved = step == 0 ? 0.0 : (antenna - on_the_way(step - 1)).norm();
    const double stray = drift * std::sqrt(moved);
    astray += Eigen::Vector3d(dice.normal(stray), dice.normal(stray), 0.0);
    const Eigen::Vector3d believed = antenna + astray;
    mapper.insert(ranges_from(antenna, 0.02, dice), antenna_at(believed.x(), believed.y()));
  }
  return mapper.drift();
}

TEST(LearntDrift, IsThatOfPosesThatStrayAtRandom) {
  for (const double drift : {0.025, 0.05}) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      const double ratio = learnt(drift, seed) / drift;
      EXPECT_GT(ratio, 0.6) << drift << " m/sqrt(m), seed " << seed;
      EXPECT_LT(ratio, 1.6) << drift << " m/sqrt(m), seed " << seed;
    }
  }
}

// One beacon is heard by way of a reflection for 37 of 80 messages, as if it stood elsewhere.
void disturb(int step, BeaconRanges& z) {
  if (step % 80 < 43) return;
  double& range = z.ranges[0].range;
  range = 0.1 + std::abs(range - 4.0 - 2.0 * std::sin(0.1 * step));
}

TEST(LearntDrift, IsNotThatOfPosesThatComeLateAndOfWrongRangesInRuns) {
  for (const int late : {0, 1}) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      Dice dice(seed);
      BeaconMapper mapper(BeaconOptions{});
      for (int step = 0; step < 340; ++step) {
        BeaconRanges z = ranges_from(on_the_way(step), 0.05, dice);
        disturb(step, z);
        const Eigen::Vector3d believed = on_the_way(step - late);
        mapper.insert(z, antenna_at(believed.x(), believed.y()));
      }
      for (const BeaconEstimate& beacon : mapper.estimates()) {
        const double error = (beacon.modes[0].mean - kBeacons.at(beacon.id)).norm();
        EXPECT_LT(error, late == 0 ? 0.1 : 1.0) << "beacon " << beacon.id << ", seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace portolan
