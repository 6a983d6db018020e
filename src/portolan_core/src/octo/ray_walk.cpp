// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ray_walk.hpp"

#include <cmath>
#include <limits>

namespace portolan {

namespace {

constexpr double kNever = std::numeric_limits<double>::max();

RayWalk::Cell cell_of(const octomap::OcTreeKey& key) {
  return RayWalk::cell(key[0], key[1], key[2]);
}

/// Where the ray meets the first border across axis `i`, and the distance to the next ones.
void set_axis(const VoxelLattice& lattice, int key, float origin, float direction, unsigned i,
              RayWalk& ray) {
  const int sign = (direction > 0.0F) - (direction < 0.0F);
  ray.step[i] = static_cast<RayWalk::Cell>(sign) << (RayWalk::kBits * static_cast<int>(i));
  if (sign == 0) {
    ray.t[i] = ray.t_delta[i] = kNever;
    return;
  }
  const auto to_border = static_cast<float>(sign * lattice.resolution() * 0.5);
  const double border = lattice.centre(key) + static_cast<double>(to_border);
  ray.t[i] = (border - static_cast<double>(origin)) / static_cast<double>(direction);
  ray.t_delta[i] = lattice.resolution() / std::fabs(static_cast<double>(direction));
}

}  // namespace

std::optional<RayWalk> ray_walk(const VoxelLattice& lattice, const octomap::point3d& origin,
                                const octomap::point3d& end) {
  const auto key_origin = lattice.key(origin);
  const auto key_end = lattice.key(end);
  if (!key_origin || !key_end || *key_origin == *key_end) return std::nullopt;
  octomap::point3d direction = end - origin;
  const auto length = static_cast<float>(direction.norm());
  if (!(length > 0.0F && std::isfinite(length))) return std::nullopt;
  direction /= length;
  RayWalk ray;
  ray.length = static_cast<double>(length);
  ray.start = cell_of(*key_origin);
  ray.end = cell_of(*key_end);
  for (unsigned i = 0; i < 3; ++i) {
    set_axis(lattice, (*key_origin)[i], origin(i), direction(i), i, ray);
  }
  return ray;
}

}  // namespace portolan
