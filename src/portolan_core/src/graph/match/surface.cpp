// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/surface.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace portolan {

namespace {

// The cube's coordinates in one word; cubes 2 million sides apart may share it.
std::uint64_t cube_of(const Eigen::Vector3d& point, double side) {
  const auto part = [&](int axis) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(point[axis] / side))) &
           0x1fffff;
  };
  return part(0) | part(1) << 21 | part(2) << 42;
}

}  // namespace

void append(const Surface& surface, const Pose& T_all_surface, Surface& all) {
  all.points.reserve(all.size() + surface.size());
  all.normals.reserve(all.size() + surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    all.add(T_all_surface * surface.points[i], T_all_surface.linear() * surface.normals[i]);
  }
}

Surface thinned(const Surface& surface, double side) {
  if (side <= 0.0) return surface;
  Surface kept;
  std::unordered_set<std::uint64_t> taken;
  taken.reserve(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (taken.insert(cube_of(surface.points[i], side)).second) {
      kept.add(surface.points[i], surface.normals[i]);
    }
  }
  return kept;
}

}  // namespace portolan
