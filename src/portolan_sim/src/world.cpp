// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/world.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace portolan::sim {

namespace {

using Point = WorldOptions::Point;

Eigen::Vector2d planar(const Point& point) { return {point[0], point[1]}; }

/// One straight piece, half a thickness longer at both ends so that corners close.
Obstacle wall_piece(const WorldOptions::Wall& wall, const Point& from, const Point& to) {
  const Eigen::Vector2d along = planar(to) - planar(from);
  Obstacle piece;
  piece.center = 0.5 * (planar(from) + planar(to));
  if (along.norm() > 0.0) piece.axis = along.normalized();
  piece.half = {0.5 * along.norm() + 0.5 * wall.thickness, 0.5 * wall.thickness};
  piece.bottom = wall.bottom;
  piece.top = wall.bottom + wall.height;
  piece.material = wall.material;
  return piece;
}

Obstacle block(const WorldOptions::Box& box) {
  Obstacle block;
  block.center = planar(box.center);
  block.axis = {std::cos(box.yaw), std::sin(box.yaw)};
  block.half = 0.5 * planar(box.size);
  block.bottom = box.bottom;
  block.top = box.bottom + box.height;
  block.material = box.material;
  return block;
}

Obstacle pillar(const WorldOptions::Cylinder& cylinder) {
  Obstacle pillar;
  pillar.footprint = Obstacle::Footprint::disc;
  pillar.center = planar(cylinder.center);
  pillar.half = Eigen::Vector2d::Constant(cylinder.radius);
  pillar.bottom = cylinder.bottom;
  pillar.top = cylinder.bottom + cylinder.height;
  pillar.material = cylinder.material;
  return pillar;
}

std::vector<Obstacle> obstacles_of(const WorldOptions& options) {
  std::vector<Obstacle> obstacles;
  for (const WorldOptions::Wall& wall : options.walls) {
    for (std::size_t i = 1; i < wall.points.size(); ++i) {
      obstacles.push_back(wall_piece(wall, wall.points[i - 1], wall.points[i]));
    }
  }
  for (const WorldOptions::Box& box : options.boxes) obstacles.push_back(block(box));
  for (const WorldOptions::Cylinder& round : options.cylinders) obstacles.push_back(pillar(round));
  return obstacles;
}

World::Marks marks_of(const std::vector<WorldOptions::Mark>& listed, const std::string& kind) {
  World::Marks marks;
  std::vector<std::string> faults;
  for (const WorldOptions::Mark& mark : listed) {
    const Eigen::Vector3d position(mark.position[0], mark.position[1], mark.position[2]);
    if (!marks.emplace(mark.id, position).second) {
      faults.push_back(kind + ": two have the id " + std::to_string(mark.id));
    }
  }
  if (!faults.empty()) throw OptionsError(std::move(faults));
  return marks;
}

/// Where the ray meets a level plane that it comes at from the side of `normal_z`.
std::optional<Hit> meet_plane(const Ray& ray, double z, double normal_z, double max_range) {
  const double speed = ray.direction.z() * normal_z;
  if (speed >= 0.0) return std::nullopt;
  const double range = (z - ray.origin.z()) / ray.direction.z();
  if (range < 0.0 || range > max_range) return std::nullopt;
  return Hit{range, {0.0, 0.0, normal_z}, Material::ordinary};
}

}  // namespace

World::World(const Options& options)
    : caster_(obstacles_of(checked(options))),
      landmarks_(marks_of(options.landmarks, "landmarks")),
      beacons_(marks_of(options.beacons, "beacons")),
      floor_(options.floor),
      ceiling_(options.ceiling) {}

std::optional<Hit> World::cast(const Ray& ray, Wave wave, double max_range) const {
  std::optional<Hit> level;
  if (floor_) level = meet_plane(ray, 0.0, 1.0, max_range);
  if (ceiling_ > 0.0 && !level) level = meet_plane(ray, ceiling_, -1.0, max_range);
  const std::optional<Hit> hit = caster_.cast(ray, wave, level ? level->range : max_range);
  return hit ? hit : level;
}

bool World::sees(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double slack) const {
  const double range = (to - from).norm() - slack;
  if (range <= 0.0) return true;
  return !caster_.cast({from, (to - from).normalized()}, Wave::light, range);
}

double World::clearance(const Eigen::Vector2d& p_map, double reach, double bottom,
                        double top) const {
  return caster_.clearance(p_map, reach, bottom, top);
}

bool World::is_solid(const Eigen::Vector3d& p_map) const {
  if ((floor_ && p_map.z() < 0.0) || (ceiling_ > 0.0 && p_map.z() > ceiling_)) return true;
  return std::any_of(obstacles().begin(), obstacles().end(), [&](const Obstacle& obstacle) {
    return obstacle.bottom <= p_map.z() && p_map.z() <= obstacle.top &&
           distance(obstacle, p_map.head<2>()) == 0.0;
  });
}

bool World::reaches_into(const Eigen::Vector3d& cube_center, double half_side) const {
  const double z = cube_center.z();
  if (floor_ && std::abs(z) <= half_side) return true;
  if (ceiling_ > 0.0 && std::abs(z - ceiling_) <= half_side) return true;
  return std::any_of(obstacles().begin(), obstacles().end(), [&](const Obstacle& obstacle) {
    return obstacle.bottom <= z + half_side && z - half_side <= obstacle.top &&
           overlaps(obstacle, cube_center.head<2>(), half_side);
  });
}

}  // namespace portolan::sim
