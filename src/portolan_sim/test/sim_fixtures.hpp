// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/sim/random.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A square room with its corner at the origin, inner faces at 0 and `side` [m].
inline WorldOptions room(double side, Material material = Material::ordinary) {
  WorldOptions world;
  WorldOptions::Wall wall;
  const double low = -0.05;
  const double high = side + 0.05;
  wall.points = {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}};
  wall.material = material;
  world.walls.push_back(wall);
  return world;
}

/// Blocks and pillars of all materials, anywhere within `extent` [m] of the origin.
inline WorldOptions clutter(int obstacles, double extent, Random& random) {
  WorldOptions world;
  const auto material = [&] { return static_cast<Material>(random.index(3)); };
  const auto place = [&] { return random.uniform(-extent, extent); };
  for (int i = 0; i < obstacles; ++i) {
    WorldOptions::Box box;
    box.center = {place(), place()};
    box.size = {random.uniform(0.05, 3.0), random.uniform(0.05, 1.0)};
    box.yaw = random.uniform(-3.0, 3.0);
    box.bottom = random.uniform(-0.5, 1.0);
    box.height = random.uniform(0.1, 2.0);
    box.material = material();
    world.boxes.push_back(box);
    WorldOptions::Cylinder cylinder;
    cylinder.center = {place(), place()};
    cylinder.radius = random.uniform(0.05, 0.5);
    cylinder.material = material();
    world.cylinders.push_back(cylinder);
  }
  return world;
}

inline Eigen::Vector3d any_direction(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

}  // namespace portolan::sim
