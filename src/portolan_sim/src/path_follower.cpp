// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace portolan::sim {

PathFollower::PathFollower(const Options& options, std::vector<Eigen::Vector2d> points)
    : options_(checked(options)), points_(std::move(points)) {}

Velocity PathFollower::steer(const Pose& T_map_base, double duration) {
  if (left_to_spin_ > 0.0) return spin(duration);
  while (next_ < points_.size()) {
    const Eigen::Vector2d to_point = points_[next_] - T_map_base.translation().head<2>();
    if (to_point.norm() > options_.tolerance) {
      const double heading = wrap_angle(std::atan2(to_point.y(), to_point.x()) - yaw(T_map_base));
      return approach(to_point, heading);
    }
    ++next_;
    left_to_spin_ = std::abs(options_.spin_at_points);
    if (left_to_spin_ > 0.0) return spin(duration);
  }
  return {};
}

Velocity PathFollower::spin(double duration) {
  left_to_spin_ -= options_.turn_rate * duration;
  return {0.0, std::copysign(options_.turn_rate, options_.spin_at_points)};
}

/// Stands while it turns far; else drives, slower towards the point, and keeps turning to it.
Velocity PathFollower::approach(const Eigen::Vector2d& to_point, double heading) const {
  constexpr double kGain = 3.0;     // turn rate per angle [1/s]
  constexpr double kSlowing = 1.0;  // speed per distance [1/s]
  constexpr double kSlowest = 0.1;  // so that it arrives [m/s]
  const double turn = std::clamp(kGain * heading, -options_.turn_rate, options_.turn_rate);
  if (std::abs(heading) > options_.sharp_turn) return {0.0, turn};
  const double slowed = std::max(kSlowest, kSlowing * to_point.norm());
  return {std::min(options_.speed, slowed), turn};
}

}  // namespace portolan::sim
