// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "portolan/pose.hpp"

namespace portolan::testing {

/// Random numbers, points and poses that are the same on every standard library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  double normal(double stddev) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return stddev * radius * std::cos(2.0 * M_PI * uniform(0.0, 1.0));
  }
  /// In a cube about the origin; `size` is half its side.
  Eigen::Vector3d point(double size) {
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }
  Pose pose(double size) {
    Pose pose = Pose::Identity();
    pose.translation() = point(size);
    const Eigen::Vector3d axis = point(1.0).normalized();
    pose.linear() = Eigen::AngleAxisd(uniform(-3.0, 3.0), axis).toRotationMatrix();
    return pose;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace portolan::testing
