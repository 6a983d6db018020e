// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// Walls in the plane, and what a laser sees of them: for tests that must know the truth.
class FlatWorld {
 public:
  FlatWorld& wall(double x0, double y0, double x1, double y1) {
    walls_.push_back({{x0, y0}, {x1, y1}});
    return *this;
  }
  FlatWorld& box(double x0, double y0, double x1, double y1) {
    return wall(x0, y0, x1, y0).wall(x1, y0, x1, y1).wall(x1, y1, x0, y1).wall(x0, y1, x0, y0);
  }
  FlatWorld& circle(double radius, int sides) {
    const double step = 2.0 * M_PI / sides;
    for (int i = 0; i < sides; ++i) {
      wall(radius * std::cos(i * step), radius * std::sin(i * step),
           radius * std::cos((i + 1) * step), radius * std::sin((i + 1) * step));
    }
    return *this;
  }

  /// All round, `beams` of them, with a Gaussian error of each range [m]; +Inf where nothing is.
  RangeScan scan(const Pose& T_map_sensor, int beams, double noise, std::mt19937_64& random) const {
    RangeScan scan;
    scan.angle_min = -M_PI;
    scan.angle_increment = 2.0 * M_PI / beams;
    scan.range_min = 0.05;
    scan.range_max = 30.0;
    std::normal_distribution<double> error(0.0, 1.0);
    const Eigen::Vector2d origin = T_map_sensor.translation().head<2>();
    for (int i = 0; i < beams; ++i) {
      const double angle = yaw(T_map_sensor) + scan.angle_min + i * scan.angle_increment;
      const double range = cast(origin, {std::cos(angle), std::sin(angle)});
      scan.ranges.push_back(static_cast<float>(range + noise * error(random)));
    }
    return scan;
  }

 private:
  struct Wall {
    Eigen::Vector2d from, to;
  };

  double cast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls_) {
      const Eigen::Vector2d along = wall.to - wall.from;
      const Eigen::Vector2d start = wall.from - origin;
      const double cross = direction.x() * along.y() - direction.y() * along.x();
      if (cross == 0.0) continue;
      const double range = (start.x() * along.y() - start.y() * along.x()) / cross;
      const double share = (start.x() * direction.y() - start.y() * direction.x()) / cross;
      if (range > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, range);
    }
    return nearest;
  }

  std::vector<Wall> walls_;
};

/// A room of 8 by 6 metres around the origin with a niche, a pillar and a table.
inline FlatWorld room() {
  FlatWorld world;
  world.wall(-4, -3, 4, -3).wall(4, -3, 4, 3).wall(4, 3, 1, 3).wall(1, 3, 1, 2).wall(1, 2, -4, 2);
  return world.wall(-4, 2, -4, -3).box(-2.6, -1.9, -2.2, -1.5).box(2.0, -0.4, 2.8, 0.3);
}

/// Two endless walls.
inline FlatWorld corridor() {
  FlatWorld world;
  return world.wall(-200, -1, 200, -1).wall(-200, 1.2, 200, 1.2);
}

}  // namespace portolan
