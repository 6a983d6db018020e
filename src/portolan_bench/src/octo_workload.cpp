// SPDX-License-Identifier: BSD-3-Clause
#include "octo_workload.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace portolan::bench {

namespace {

Eigen::AlignedBox3d box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

/// Rooms of 6 m with doors of 1 m and a table and a cupboard in each.
BoxWorld rooms(int count) {
  const double side = 6.0 * count;
  BoxWorld world{box(0, 0, 0, side, side, 2.8), {}};
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double x = 6.0 * i;
      const double y = 6.0 * j;
      const double door = 1.0 + (7 * i + 3 * j) % 4;
      if (i > 0) {
        world.boxes.push_back(box(x - 0.1, y, 0, x + 0.1, y + door, 2.8));
        world.boxes.push_back(box(x - 0.1, y + door + 1.0, 0, x + 0.1, y + 6.0, 2.8));
        world.boxes.push_back(box(x - 0.1, y + door, 2.0, x + 0.1, y + door + 1.0, 2.8));
      }
      if (j > 0) {
        world.boxes.push_back(box(x, y - 0.1, 0, x + door, y + 0.1, 2.8));
        world.boxes.push_back(box(x + door + 1.0, y - 0.1, 0, x + 6.0, y + 0.1, 2.8));
        world.boxes.push_back(box(x + door, y - 0.1, 2.0, x + door + 1.0, y + 0.1, 2.8));
      }
      world.boxes.push_back(box(x + 4.0, y + 4.2, 0.7, x + 5.2, y + 5.0, 0.75));
      world.boxes.push_back(box(x + 0.2, y + 4.8, 0.0, x + 1.0, y + 5.6, 1.9));
    }
  }
  return world;
}

/// Halls of 40 m with pillars, behind each other.
BoxWorld hall(int count) {
  BoxWorld world{box(0, 0, 0, 40.0 * count, 40, 9), {}};
  for (int i = 0; i < 4 * count; ++i) {
    for (int j = 0; j < 4; ++j) {
      world.boxes.push_back(box(10.0 * i + 5, 10.0 * j + 5, 0, 10.0 * i + 5.6, 10.0 * j + 5.6, 9));
    }
  }
  return world;
}

Directions vlp16() {
  Directions directions;
  for (int i = 0; i < 1875; ++i) {
    for (int ring = 0; ring < 16; ++ring) {
      const double azimuth = 2.0 * M_PI * i / 1875;
      const double elevation = (-15.0 + 2.0 * ring) * M_PI / 180.0;
      directions.emplace_back(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    }
  }
  return directions;
}

Directions depth_camera() {
  Directions directions;
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      directions.push_back(
          Eigen::Vector3d(1.0, -(u - 319.5) / 554.0, -(v - 239.5) / 554.0).normalized());
    }
  }
  return directions;
}

constexpr double kPeriod = 40.0;  // after which the street looks the same [m]

/// As much of the street as is seen from its middle period, x from 0 to kPeriod.
BoxWorld street() {
  BoxWorld world{box(-kPeriod, 0, 0, 2.0 * kPeriod, 20, 9), {}};
  for (int i = -4; i < 8; ++i) {
    const double x = 10.0 * i + 5.0;
    const double y = 2.0 + 16.0 * (i & 1) + 0.3 * (i & 3);
    world.boxes.push_back(box(x, y, 0, x + 0.6, y + 0.6, 9));
  }
  return world;
}

/// What is seen from a pose in a world, with a noise of 1 cm.
PointCloud seen(const OctoScene& scene, const Pose& T_world_sensor, int seed) {
  std::mt19937_64 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> noise(0.0, 0.01);
  PointCloud cloud;
  for (const Eigen::Vector3d& direction : scene.directions) {
    const double range =
        scene.world.cast(T_world_sensor.translation(), T_world_sensor.linear() * direction);
    cloud.points.emplace_back((direction * (range + noise(random))).cast<float>());
  }
  return cloud;
}

/// A walk through the middle of the building, turning.
Pose pose(const OctoScene& scene, int i) {
  const double length = scene.world.inside.sizes().x() - 3.0;
  const double way = std::fmod(scene.spacing * i, 2.0 * length);
  const double x = 1.5 + (way < length ? way : 2.0 * length - way);
  const double y = scene.world.inside.center().y() + 2.0 + 0.8 * std::sin(0.7 * x);
  return Eigen::Translation3d(x, y, 1.1) * Eigen::AngleAxisd(0.35 * i, Eigen::Vector3d::UnitZ());
}

}  // namespace

double BoxWorld::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  double nearest = 1e9;
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  const auto slabs = [&](const Eigen::AlignedBox3d& box) {
    const Eigen::Array3d a = (box.min() - origin).array() * inverse.array();
    const Eigen::Array3d b = (box.max() - origin).array() * inverse.array();
    return std::pair(a.min(b).maxCoeff(), a.max(b).minCoeff());
  };
  nearest = slabs(inside).second;
  for (const auto& box : boxes) {
    const auto [enter, leave] = slabs(box);
    if (enter > 0.0 && enter < leave) nearest = std::min(nearest, enter);
  }
  return nearest;
}

std::vector<OctoScene> octo_scenes() {
  return {{"vlp16_rooms_0.10m", rooms(4), vlp16(), 0.1, 10.0, 0.5},
          {"vlp16_hall_0.10m", hall(2), vlp16(), 0.1, 30.0, 1.0},
          {"rgbd_rooms_0.05m", rooms(4), depth_camera(), 0.05, 10.0, 0.3}};
}

PosedCloud octo_cloud(const OctoScene& scene, int i) {
  const Pose T_map_sensor = pose(scene, i);
  return {seen(scene, T_map_sensor, i), T_map_sensor};
}

OctoScene street_scene() { return {"vlp16_street_0.20m", street(), vlp16(), 0.2, 30.0, 2.0}; }

PosedCloud street_cloud(const OctoScene& scene, int i) {
  const double way = scene.spacing * i;
  const double periods = std::floor(way / kPeriod);
  const Eigen::Vector3d p(way - kPeriod * periods, 10.0 + 2.0 * std::sin(0.05 * way), 1.8);
  const Pose T_world_sensor = Eigen::Translation3d(p) *
                              Eigen::AngleAxisd(0.2 * std::sin(0.1 * i), Eigen::Vector3d::UnitZ());
  return {seen(scene, T_world_sensor, i),
          Eigen::Translation3d(kPeriod * periods, 0.0, 0.0) * T_world_sensor};
}

}  // namespace portolan::bench
