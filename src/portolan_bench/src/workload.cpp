// SPDX-License-Identifier: BSD-3-Clause
#include "workload.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <utility>

#ifdef PORTOLAN_BENCH_HAS_MRPT
#include "mrpt_rawlog.hpp"
#endif

namespace portolan::bench {

namespace {

#ifdef PORTOLAN_BENCH_HAS_MRPT
constexpr const char* kInstalledRawlog =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
#endif

struct Wall {
  Eigen::Vector2d a, b;
};

void add_box(std::vector<Wall>& walls, double x, double y, double side) {
  const Eigen::Vector2d p(x, y), q(x + side, y), r(x + side, y + side), s(x, y + side);
  walls.insert(walls.end(), {{p, q}, {q, r}, {r, s}, {s, p}});
}

std::vector<Wall> room_walls() {
  constexpr double kRoom = 6.0, kDoor = 1.0;
  constexpr int kRooms = 4;
  std::vector<Wall> walls;
  add_box(walls, 0.0, 0.0, kRooms * kRoom);
  for (int i = 1; i < kRooms; ++i) {
    for (int j = 0; j < kRooms; ++j) {
      const double at = i * kRoom;
      const double from = j * kRoom, door = from + (kRoom - kDoor) / 2.0;
      for (const auto& [low, high] :
           {std::pair(from, door), std::pair(door + kDoor, from + kRoom)}) {
        walls.push_back({{at, low}, {at, high}});
        walls.push_back({{low, at}, {high, at}});
      }
    }
  }
  return walls;
}

std::vector<Wall> hall_walls() {
  std::vector<Wall> walls;
  const Eigen::Vector2d p(0.0, 0.0), q(30.0, 0.0), r(30.0, 20.0), t(0.0, 20.0);
  walls.insert(walls.end(), {{p, q}, {q, r}, {r, t}, {t, p}});
  for (double x : {5.0, 15.0, 25.0}) {
    for (double y : {5.0, 15.0}) add_box(walls, x, y, 0.4);
  }
  return walls;
}

double distance(const std::vector<Wall>& walls, const Eigen::Vector2d& p, double angle) {
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  double nearest = std::numeric_limits<double>::infinity();
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.b - wall.a;
    const double denominator = cross(u, along);
    if (denominator == 0.0) continue;
    const double range = cross(wall.a - p, along) / denominator;
    const double part = cross(wall.a - p, u) / denominator;
    if (range > 0.0 && part >= 0.0 && part <= 1.0) nearest = std::min(nearest, range);
  }
  return nearest;
}

Workload simulate(const std::string& world, const std::vector<Wall>& walls,
                  const std::vector<Eigen::Vector3d>& path, int beams, double aperture,
                  double max_range) {
  Workload load{world + "_" + std::to_string(beams) + "b_" +
                    std::to_string(static_cast<int>(max_range)) + "m",
                max_range,
                {}};
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (const Eigen::Vector3d& at : path) {
    RangeScan scan;
    scan.angle_min = -aperture / 2.0;
    scan.angle_increment = aperture / beams;
    scan.range_min = 0.05;
    scan.range_max = max_range;
    for (int i = 0; i < beams; ++i) {
      const double angle = at.z() + scan.angle_min + i * scan.angle_increment;
      const double range = distance(walls, at.head<2>(), angle) + noise(random);
      scan.ranges.push_back(range < max_range ? static_cast<float>(range)
                                              : std::numeric_limits<float>::infinity());
    }
    load.readings.push_back({std::move(scan), planar_pose(at.x(), at.y(), at.z())});
  }
  return load;
}

// Along the middle of a corridor of rooms, through the doors, turning a little.
std::vector<Eigen::Vector3d> straight(double length, double y, int steps = 200) {
  std::vector<Eigen::Vector3d> path;
  for (int i = 0; i < steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    path.emplace_back(1.0 + part * (length - 2.0), y + 0.2 * std::sin(20.0 * part), 6.0 * part);
  }
  return path;
}

}  // namespace

Eigen::AlignedBox2d Workload::extent() const {
  Eigen::AlignedBox2d box;
  for (const Reading& reading : readings) {
    box.extend(Eigen::Vector2d(reading.T_map_sensor.translation().head<2>()));
  }
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(max_range + 2.0);
  return {box.min() - reach, box.max() + reach};
}

Workload rooms(int beams, double aperture, double max_range) {
  return simulate("rooms", room_walls(), straight(24.0, 9.0), beams, aperture, max_range);
}

Workload hall(int beams, double aperture, double max_range) {
  return simulate("hall", hall_walls(), straight(30.0, 8.0), beams, aperture, max_range);
}

Workload pings(double range, bool on_the_way) {
  constexpr int kPings = 1000;
  Workload load{"30deg_" + std::to_string(static_cast<int>(range)) + "m", 5.0, {}};
  if (on_the_way) load.name += "_on_the_way";
  for (const Eigen::Vector3d& at : straight(24.0, 9.0, kPings)) {
    const Pose place = on_the_way ? planar_pose(at.x(), at.y(), at.z()) : Pose::Identity();
    load.readings.push_back({RangeEcho{range, 0.02, 10.0, M_PI / 6.0}, place});
  }
  return load;
}

#ifdef PORTOLAN_BENCH_HAS_MRPT
Workload rawlog(const std::string& path, double max_range) {
  Workload load{"real_log", max_range, {}};
  for (RawlogScan& seen : read_rawlog(path)) {
    for (float& range : seen.scan.ranges) {
      if (static_cast<double>(range) > max_range) range = std::numeric_limits<float>::infinity();
    }
    load.readings.push_back({std::move(seen.scan), seen.T_odom_base * seen.T_base_sensor});
  }
  return load;
}
#endif

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> kAll = [] {
    std::vector<Workload> made = {rooms(360, 2.0 * M_PI, 10.0), rooms(1080, 1.5 * M_PI, 30.0),
                                  hall(360, 2.0 * M_PI, 10.0), hall(1080, 1.5 * M_PI, 30.0)};
#ifdef PORTOLAN_BENCH_HAS_MRPT
    const char* named = std::getenv("PORTOLAN_RAWLOG");
    const std::string path = named ? named : kInstalledRawlog;
    if (std::ifstream(path).good()) made.push_back(rawlog(path, 30.0));
#endif
    return made;
  }();
  return kAll;
}

}  // namespace portolan::bench
