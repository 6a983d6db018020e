// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "portolan/sim/any_sensor.hpp"
#include "portolan/sim/event.hpp"
#include "portolan/sim/odometry.hpp"
#include "portolan/sim/path_follower.hpp"
#include "portolan/sim/pose_history.hpp"
#include "portolan/sim/robot.hpp"
#include "portolan/sim/simulation_options.hpp"
#include "portolan/sim/world.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

/// A robot that drives through a world and measures: options in, timed events out.
class Simulation {
 public:
  using Options = SimulationOptions;

  /// Throws OptionsError with every fault at once.
  explicit Simulation(const Options& options);

  /// Goes on by a whole number of ticks that covers `duration`, and yields what became known
  /// meanwhile, in the order of becoming known; at one moment truth and odometry come first.
  std::vector<Event> step(Duration duration);

  /// What to drive from now on, where commands drive.
  void command(const Velocity& velocity);

  /// True where the robot follows a path and has come to its end.
  bool path_finished() const;

  Time now() const { return now_; }
  const World& world() const { return world_; }
  const Options& options() const { return options_; }
  const Robot& robot() const { return robot_; }
  const std::vector<AnySensor>& sensors() const { return sensors_; }

  /// Where the base truly is now, and was in the last second or so.
  const PoseHistory& T_map_base() const { return T_map_base_; }

  /// Where the base was at first.
  const Pose& T_map_start() const { return T_map_start_; }

  static constexpr Duration kTick = std::chrono::milliseconds(10);

 private:
  void tick(std::vector<Event>& events);
  void drive();
  void read_odometry(Time until, std::vector<Event>& events);
  void read_sensors(Time until, std::vector<Event>& events);

  Options options_;
  World world_;
  Time start_;
  Time now_;
  Pose T_map_start_;
  Robot robot_;
  PathFollower follower_;
  Odometry odometry_;
  std::vector<AnySensor> sensors_;
  std::vector<std::int64_t> counts_;  // measurements so far, by sensor
  std::int64_t odometry_count_ = 0;
  Velocity command_;
  Time commanded_;
  PoseHistory T_map_base_;
  PoseHistory T_odom_base_;
};

}  // namespace portolan::sim
