// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/expected_information.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

namespace {

constexpr std::size_t kHeaviest = 64;  // lighter modes do not sway the direction
constexpr int kDirections = 32;        // in the plane
constexpr double kShortDrive = 0.1;    // of the distance to the beacon
constexpr double kWorthDriving = 0.1;  // [nat]
constexpr double kPi = 3.14159265358979323846;

struct RangeMode {
  double weight;
  double mean;
  double variance;
};

// KL(a || b) of two Gaussians.
double divergence(const RangeMode& a, const RangeMode& b) {
  const double step = a.mean - b.mean;
  return 0.5 * (a.variance / b.variance - 1.0 + step * step / b.variance +
                std::log(b.variance / a.variance));
}

// Kolchinsky & Tracey's bound: H <= sum_i w_i (H_i - ln sum_j w_j exp(-KL(i || j))).
double entropy(const std::array<RangeMode, kHeaviest>& modes, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double overlap = 0.0;
    for (std::size_t j = 0; j < count; ++j) {
      overlap += modes[j].weight * std::exp(-divergence(modes[i], modes[j]));
    }
    sum += modes[i].weight * (0.5 * std::log(modes[i].variance) - std::log(overlap));
  }
  return sum;  // less the constant ln sqrt(2 pi e), which cancels
}

double reach_of(const std::vector<BeaconMode>& modes, const Eigen::Vector3d& p_map) {
  double reach = 0.0;
  for (const BeaconMode& mode : modes) reach += mode.weight * (mode.mean - p_map).norm();
  return kShortDrive * reach;
}

std::vector<Eigen::Vector3d> candidates(BeaconSpace space) {
  std::vector<Eigen::Vector3d> all;
  for (int i = 0; i < kDirections; ++i) {
    const double azimuth = 2.0 * kPi * i / kDirections;
    all.emplace_back(std::cos(azimuth), std::sin(azimuth), 0.0);
  }
  if (space == BeaconSpace::spatial) {
    all.emplace_back(0.0, 0.0, 1.0);
    all.emplace_back(0.0, 0.0, -1.0);
  }
  return all;
}

}  // namespace

double expected_information(const std::vector<BeaconMode>& modes, const Eigen::Vector3d& p_map,
                            double stddev) {
  std::array<RangeMode, kHeaviest> ranges;
  const std::size_t count = std::min(modes.size(), kHeaviest);
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const DistancePrediction d = predict_distance(modes[i].mean, modes[i].covariance, p_map);
    ranges[i] = {modes[i].weight, d.mean, d.variance + stddev * stddev};
    total += modes[i].weight;
  }
  for (std::size_t i = 0; i < count; ++i) ranges[i].weight /= total;
  return entropy(ranges, count) - std::log(stddev);
}

std::optional<BeaconDrive> best_drive(const std::vector<BeaconMode>& modes,
                                      const Eigen::Vector3d& p_map, double stddev,
                                      BeaconSpace space) {
  std::optional<BeaconDrive> best;
  double most = kWorthDriving;
  const double step = reach_of(modes, p_map);
  for (const Eigen::Vector3d& direction : candidates(space)) {
    const double tells = expected_information(modes, p_map + step * direction, stddev);
    if (tells <= most * (1.0 + 1e-9)) continue;  // mirror images tie: the first one stands
    most = tells;
    best = BeaconDrive{p_map, direction, step, tells};
  }
  return best;
}

}  // namespace portolan
