// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/sensor_view.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr double kMoved = 0.3;    // [m]
constexpr double kTurned = 0.2;   // [rad]
constexpr double kNearest = 0.5;  // [m]; each further bin of ranges reaches twice as far
constexpr float kDoubt = 4.0F;    // misses that are believed in before any

/// Which of `bins` equal parts of [low, high] the value lies in.
std::size_t part(double value, double low, double high, std::size_t bins) {
  const double place = (value - low) / (high - low) * static_cast<double>(bins);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins) - 1.0));
}

}  // namespace

bool SensorView::is_news(const Pose& T_map_sensor) {
  if (T_map_last_) {
    const Pose step = T_map_last_->inverse() * T_map_sensor;
    const double cos_turn = 0.5 * (step.linear().trace() - 1.0);
    if (step.translation().norm() < kMoved && cos_turn > std::cos(kTurned)) return false;
  }
  T_map_last_ = T_map_sensor;
  return true;
}

void SensorView::note(const Eigen::Vector3d& l, bool seen) {
  Count& count = counts_[bin(l)];
  (seen ? count.seen : count.missed) += 1.0F;
}

double SensorView::p_detection(const Eigen::Vector3d& l) const {
  // Where too little is known, what is nearer is seen as well as what is behind it.
  std::size_t i = bin(l);
  const std::size_t furthest = i - i % kRanges + kRanges - 1;
  while (i < furthest && counts_[i].seen + counts_[i].missed < kDoubt) ++i;
  const Count& count = counts_[i];
  return static_cast<double>(count.seen / (count.seen + count.missed + kDoubt));
}

std::size_t SensorView::bin(const Eigen::Vector3d& l) {
  const double in_plane = l.head<2>().norm();
  const std::size_t azimuth = part(std::atan2(l.y(), l.x()), -M_PI, M_PI, kAzimuths);
  const std::size_t elevation =
      part(std::atan2(l.z(), in_plane), -0.5 * M_PI, 0.5 * M_PI, kElevations);
  const double octave = std::log2(std::max(l.norm() / kNearest, 1.0));
  const std::size_t range = part(octave, 0.0, static_cast<double>(kRanges), kRanges);
  return (azimuth * kElevations + elevation) * kRanges + range;
}

}  // namespace portolan
