// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/view.hpp"

#include <algorithm>
#include <cmath>

namespace portolan::sim {

namespace {

/// A level ray from the sensor, at an angle from its x axis.
Ray ray_at(const Pose& T_map_sensor, double angle) {
  return {T_map_sensor.translation(),
          T_map_sensor.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)};
}

/// So many steps that the ends of neighbouring rays lie less than a cell apart.
int steps_for(double field, double reach, double resolution) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(field) * reach / resolution)));
}

bool are_close(const Pose& a, const Pose& b, double distance) {
  constexpr double kTurn = 0.05;  // [rad]
  const Pose moved = a.inverse() * b;
  return moved.translation().norm() < distance && rotation_angle(moved) < kTurn;
}

}  // namespace

View::View(const TruthGrid& truth) : grid_(truth) {
  std::fill(grid_.cells.begin(), grid_.cells.end(), TruthGrid::Cell::unknown);
}

void View::look(const World& world, const AnySensor& sensor, const Pose& T_map_base) {
  const std::string frame = mounts(sensor).front().frame;
  const auto last = looked_from_.find(frame);
  if (last != looked_from_.end() && are_close(last->second, T_map_base, 2.0 * grid_.resolution)) {
    return;
  }
  looked_from_[frame] = T_map_base;
  std::visit([&](const auto& one) { look(world, one, T_map_base); }, sensor);
}

void View::look(const World& world, const Laser& laser, const Pose& T_map_base) {
  const Laser::Options& options = laser.options();
  const Pose T_map_laser = T_map_base * mount(options);
  const double field = options.angle_max - options.angle_min;
  const double reach = options.noise.range_max;
  const int steps = steps_for(field, reach, grid_.resolution);
  for (int i = 0; i <= steps; ++i) {
    look_along(world, ray_at(T_map_laser, options.angle_min + field * i / steps), Wave::light,
               reach);
  }
}

void View::look(const World& world, const SonarRing& ring, const Pose& T_map_base) {
  const SonarRing::Options& options = ring.options();
  for (std::size_t sonar = 0; sonar < ring.size(); ++sonar) {
    const Pose T_map_sonar = T_map_base * ring.mount(sonar);
    // A sonar knows no more of its cone than the range of the first echo.
    const double echo = ring.nearest(sonar, world, T_map_base);
    const double reach = std::min(options.noise.range_max, echo + grid_.resolution);
    const int steps = steps_for(options.aperture, reach, grid_.resolution);
    for (int i = 0; i <= steps; ++i) {
      const double angle = options.aperture * (static_cast<double>(i) / steps - 0.5);
      look_along(world, ray_at(T_map_sonar, angle), Wave::sound, reach);
    }
  }
}

void View::look_along(const World& world, const Ray& ray, Wave wave, double reach) {
  const std::optional<Hit> hit = world.cast(ray, wave, reach);
  const double end = hit ? hit->range : reach;
  for (double range = 0.0; range < end; range += 0.5 * grid_.resolution) {
    const Eigen::Vector2i cell = grid_.cell_of((ray.origin + range * ray.direction).head<2>());
    if (grid_.contains(cell) && grid_.at(cell) == TruthGrid::Cell::unknown) {
      grid_.at(cell) = TruthGrid::Cell::free;
    }
  }
  if (!hit || !returns(wave, hit->material)) return;
  constexpr double kBehindSurface = 1e-3;  // [m]
  const Eigen::Vector3d p_map = ray.origin + (end + kBehindSurface) * ray.direction;
  const Eigen::Vector2i cell = grid_.cell_of(p_map.head<2>());
  if (grid_.contains(cell)) grid_.at(cell) = TruthGrid::Cell::occupied;
}

}  // namespace portolan::sim
