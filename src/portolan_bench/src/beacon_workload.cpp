// SPDX-License-Identifier: BSD-3-Clause
#include "beacon_workload.hpp"

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace portolan::bench {

namespace {

constexpr int kSteps = 150;
constexpr double kStep = 0.1;  // [m]

BeaconWorkload drive(std::string name, double stddev, double turn) {
  BeaconWorkload load;
  load.name = std::move(name);
  load.stddev = stddev;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-8.0, 8.0);
  std::normal_distribution<double> noise(0.0, stddev);
  for (BeaconId id = 0; id < 8; ++id) load.truth[id] = {side(random), side(random), 0.0};
  Pose pose = planar_pose(-7.0, -4.0, 0.3);
  for (int step = 0; step < kSteps; ++step) {
    BeaconWorkload::PosedRanges posed{{}, pose};
    for (const auto& [id, p] : load.truth) {
      posed.z.ranges.push_back({id, (p - pose.translation()).norm() + noise(random), stddev});
    }
    load.posed.push_back(std::move(posed));
    pose = pose * planar_pose(kStep, 0.0, turn);
  }
  return load;
}

}  // namespace

std::size_t BeaconWorkload::ranges() const {
  std::size_t count = 0;
  for (const PosedRanges& p : posed) count += p.z.ranges.size();
  return count;
}

BeaconWorkload straight_drive(double stddev) { return drive("straight", stddev, 0.0); }
BeaconWorkload loop_drive(double stddev) { return drive("loop", stddev, 0.04); }

BeaconMapper map_beacons(const BeaconOptions& options, const BeaconWorkload& load) {
  BeaconMapper mapper(options);
  for (const auto& posed : load.posed) mapper.insert(posed.z, posed.T_map_sensor);
  return mapper;
}

Places places(const BeaconMapper& mapper) {
  Places places;
  for (const BeaconEstimate& estimate : mapper.estimates()) {
    places[estimate.id] = estimate.modes[0].mean;
  }
  return places;
}

Places read_places(const std::string& path) {
  std::ifstream table(path);
  Places places;
  for (std::string line; std::getline(table, line);) {
    std::istringstream words(line);
    BeaconId id = 0;
    double x = 0.0;
    double y = 0.0;
    if (words >> id >> x >> y) places[id] = {x, y, 0.0};
  }
  if (places.empty()) throw std::runtime_error(path + ": holds no lines `id x y`");
  return places;
}

}  // namespace portolan::bench
