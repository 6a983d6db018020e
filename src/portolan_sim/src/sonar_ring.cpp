// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/sonar_ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace portolan::sim {

namespace {

/// Rays on a square raster within the cone's round cross-section, the middle row level.
std::vector<Eigen::Vector3d> cone_of(double aperture, int rays) {
  if (rays == 1) return {Eigen::Vector3d::UnitX()};
  const double half = 0.5 * aperture;
  const double step = aperture / (rays - 1);
  const int levels = (rays - 1) / 2;
  std::vector<Eigen::Vector3d> cone;
  for (int level = -levels; level <= levels; ++level) {
    for (int i = 0; i < rays; ++i) {
      const double up = level * step;
      const double aside = i * step - half;
      constexpr double kRounding = 1e-9;
      if (std::hypot(up, aside) > half + kRounding) continue;
      cone.emplace_back(std::cos(up) * std::cos(aside), std::cos(up) * std::sin(aside),
                        std::sin(up));
    }
  }
  return cone;
}

}  // namespace

SonarRing::SonarRing(const Options& options, std::uint64_t seed)
    : options_(checked(options)),
      random_(seed, options.frame),
      cone_(cone_of(options.aperture, options.rays)) {}

std::string SonarRing::frame(std::size_t sonar) const {
  return options_.frame + "_" + std::to_string(sonar);
}

Pose SonarRing::mount(std::size_t sonar) const {
  return sim::mount(options_) * planar_pose(0.0, 0.0, options_.angles[sonar]) *
         Eigen::Translation3d(options_.radius, 0.0, 0.0);
}

double SonarRing::nearest(std::size_t sonar, const World& world, const Pose& T_map_base) const {
  const Pose T_map_sonar = T_map_base * mount(sonar);
  const double least_cosine = std::cos(std::min(options_.specular_angle, M_PI));
  double range = options_.noise.range_max;
  bool heard = false;
  for (const Eigen::Vector3d& direction : cone_) {
    const Ray ray{T_map_sonar.translation(), T_map_sonar.linear() * direction};
    const std::optional<Hit> hit = world.cast(ray, Wave::sound, range);
    if (!hit || !returns(Wave::sound, hit->material)) continue;
    if (-hit->normal.dot(ray.direction) < least_cosine) continue;
    range = hit->range;
    heard = true;
  }
  return heard ? range : std::numeric_limits<double>::infinity();
}

RangeEcho SonarRing::sense(std::size_t sonar, const World& world, const Pose& T_map_base) {
  const bool crossed = random_.chance(options_.crosstalk);
  const std::size_t other =
      (sonar + 1 + random_.index(std::max<std::size_t>(size() - 1, 1))) % size();
  double range = nearest(sonar, world, T_map_base);
  if (crossed && other != sonar) range = std::min(range, nearest(other, world, T_map_base));
  RangeEcho echo;
  echo.range_min = options_.noise.range_min;
  echo.range_max = options_.noise.range_max;
  echo.aperture = options_.aperture;
  echo.range = options_.noise.measure(range, random_);
  return echo;
}

}  // namespace portolan::sim
