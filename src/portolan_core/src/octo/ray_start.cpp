// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ray_start.hpp"

#include <cmath>
#include <limits>

namespace portolan {

namespace {

constexpr double kNever = std::numeric_limits<double>::max();

}  // namespace

RayStart::RayStart(const VoxelLattice& lattice, const octomap::point3d& origin)
    : origin_(origin), key_(lattice.key(origin)), resolution_(lattice.resolution()) {
  if (!key_) return;
  for (unsigned i = 0; i < 3; ++i) {
    for (const int side : {0, 1}) {
      const int sign = side == 0 ? -1 : 1;
      const auto half = static_cast<float>(sign * resolution_ * 0.5);
      const double border = lattice.centre((*key_)[i]) + static_cast<double>(half);
      to_border_[static_cast<std::size_t>(side)][i] = border - static_cast<double>(origin(i));
    }
  }
}

std::optional<RayWalk> RayStart::walk_to(const octomap::point3d& end,
                                         const octomap::OcTreeKey& key_end,
                                         const RayWalk::Axes& axes) const {
  std::optional<RayWalk> walk;
  if (!key_ || *key_ == key_end) return walk;
  octomap::point3d direction = end - origin_;
  const auto length = static_cast<float>(direction.norm());
  if (!(length > 0.0F && std::isfinite(length))) return walk;
  direction /= length;
  RayWalk& ray = walk.emplace();
  ray.length = static_cast<double>(length);
  ray.start = axes.cell(*key_);
  ray.end = axes.cell(key_end);
  ray.step = {axes.x, axes.y, axes.z};
  for (unsigned i = 0; i < 3; ++i) {
    const auto along = static_cast<double>(direction(i));
    ray.t[i] = to_border_[along > 0.0 ? 1 : 0][i] / along;
    ray.t_delta[i] = resolution_ / std::fabs(along);
    if (along < 0.0) ray.step[i] = RayWalk::Cell{0} - ray.step[i];
    if (along == 0.0) ray.t[i] = ray.t_delta[i] = kNever;
  }
  return walk;
}

}  // namespace portolan
