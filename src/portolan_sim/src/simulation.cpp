// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace portolan::sim {

namespace {

using Point = WorldOptions::Point;

const std::vector<Point>& path_of(const SimulationOptions& options) {
  return options.path.empty() ? options.world.tour : options.path;
}

std::vector<Eigen::Vector2d> points_of(const SimulationOptions& options) {
  std::vector<Eigen::Vector2d> points;
  for (const Point& point : path_of(options)) points.emplace_back(point[0], point[1]);
  return points;
}

/// Where told; else at the begin of the path, looking along it; else where the world says.
Pose start_of(const SimulationOptions& options) {
  const Point& start = options.start.empty() ? options.world.start : options.start;
  const std::vector<Point>& path = path_of(options);
  if (!options.start.empty() || options.drive != Drive::path || path.empty()) {
    return planar_pose(start[0], start[1], start[2]);
  }
  const Point& next = path[std::min<std::size_t>(1, path.size() - 1)];
  const double heading = std::atan2(next[1] - path[0][1], next[0] - path[0][0]);
  return planar_pose(path[0][0], path[0][1], heading);
}

/// The stamp of a measurement that comes so many times a second, without adding up rounding.
Time stamp_of(Time start, std::int64_t count, double rate) {
  return start + Duration{std::llround(static_cast<double>(count) * 1e9 / rate)};
}

/// The longest that any measurement takes, and a second to look back.
Duration memory_of(const std::vector<AnySensor>& sensors) {
  Duration longest{0};
  for (const AnySensor& sensor : sensors) longest = std::max(longest, duration(sensor));
  return longest + std::chrono::seconds(1);
}

}  // namespace

Simulation::Simulation(const Options& options)
    : options_(checked(options)),
      world_(options.world),
      start_(Time{} + seconds(options.start_time)),
      now_(start_),
      T_map_start_(start_of(options)),
      robot_(options.robot, T_map_start_),
      follower_(options.follower, points_of(options)),
      odometry_(options.odometry, static_cast<std::uint64_t>(options.seed),
                options.odometry_origin == OdometryOrigin::map ? T_map_start_ : Pose::Identity()),
      sensors_(sensors_of(options)),
      counts_(sensors_.size(), 0),
      commanded_(start_),
      T_map_base_(memory_of(sensors_)),
      T_odom_base_(memory_of(sensors_)) {
  T_map_base_.add(now_, robot_.T_map_base());
}

std::vector<Event> Simulation::step(Duration duration) {
  std::vector<Event> events;
  for (const Time end = now_ + duration; now_ < end;) tick(events);
  return events;
}

/// What becomes known from now until the next tick, which itself belongs to the one after.
void Simulation::tick(std::vector<Event>& events) {
  drive();
  const Time until = now_ + kTick;
  T_map_base_.add(until, robot_.T_map_base());
  std::vector<Event> latest;
  read_odometry(until, latest);
  read_sensors(until, latest);
  std::stable_sort(latest.begin(), latest.end(),
                   [](const Event& a, const Event& b) { return a.known < b.known; });
  std::move(latest.begin(), latest.end(), std::back_inserter(events));
  now_ = until;
}

void Simulation::drive() {
  Velocity wanted;
  if (options_.drive == Drive::path) {
    wanted = follower_.steer(robot_.T_map_base(), to_seconds(kTick));
  } else if (options_.command_timeout == 0.0 ||
             to_seconds(now_ - commanded_) < options_.command_timeout) {
    wanted = command_;
  }
  robot_.advance(kTick, wanted, world_);
}

void Simulation::read_odometry(Time until, std::vector<Event>& events) {
  while (true) {
    const Time stamp = stamp_of(start_, odometry_count_, options_.odometry_rate);
    if (stamp >= until) return;
    const Pose T_map_base = T_map_base_.at(stamp);
    odometry_.update(T_map_base);
    T_odom_base_.add(stamp, odometry_.T_odom_base());
    events.push_back(
        {stamp, stamp, "ground_truth", "map", Event::Truth{T_map_base, robot_.velocity()}});
    events.push_back(
        {stamp, stamp, "odom", "odom",
         Event::Odometry{odometry_.T_odom_base(), odometry_.covariance(), robot_.velocity()}});
    ++odometry_count_;
  }
}

void Simulation::read_sensors(Time until, std::vector<Event>& events) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    while (true) {
      const Time stamp = stamp_of(start_, counts_[i], rate(sensors_[i]));
      if (stamp + duration(sensors_[i]) >= until) break;
      const Moment moment{world_, T_map_base_, T_odom_base_, stamp, counts_[i]};
      measure(sensors_[i], moment, events);
      ++counts_[i];
    }
  }
}

void Simulation::command(const Velocity& velocity) {
  command_ = velocity;
  commanded_ = now_;
}

bool Simulation::path_finished() const {
  return options_.drive == Drive::path && follower_.finished();
}

}  // namespace portolan::sim
