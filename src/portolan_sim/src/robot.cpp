// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/robot.hpp"

#include <algorithm>
#include <cmath>

namespace portolan::sim {

namespace {

double towards(double now, double wanted, double most) {
  return now + std::clamp(wanted - now, -most, most);
}

}  // namespace

Pose driven(const Velocity& velocity, double duration) {
  const double way = velocity.forward * duration;
  const double turn = velocity.turn * duration;
  if (std::abs(turn) < 1e-9) return planar_pose(way, 0.5 * way * turn, turn);
  const double radius = way / turn;
  return planar_pose(radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn);
}

Robot::Robot(const Options& options, const Pose& T_map_base)
    : options_(checked(options)), T_map_base_(T_map_base) {}

void Robot::advance(Duration duration, const Velocity& wanted, const World& world) {
  const double dt = to_seconds(duration);
  const double forward = std::clamp(wanted.forward, -options_.max_speed, options_.max_speed);
  const double turn = std::clamp(wanted.turn, -options_.max_turn_rate, options_.max_turn_rate);
  velocity_.forward = towards(velocity_.forward, forward, options_.max_acceleration * dt);
  velocity_.turn = towards(velocity_.turn, turn, options_.max_turn_acceleration * dt);

  const Pose T_map_next = T_map_base_ * driven(velocity_, dt);
  const auto room = [&](const Pose& pose) {
    return world.clearance(pose.translation().head<2>(), options_.radius, 0.0, options_.height);
  };
  const double room_next = room(T_map_next);
  blocked_ = room_next < options_.radius && room_next < room(T_map_base_);
  if (blocked_) {
    velocity_ = {};
  } else {
    T_map_base_ = T_map_next;
  }
}

}  // namespace portolan::sim
