// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "portolan/sim/material.hpp"
#include "portolan/sim/ray.hpp"

namespace portolan::sim {

/// A solid that stands or hangs upright: a rectangle or a disc, drawn out from bottom to top.
struct Obstacle {
  enum class Footprint { rectangle, disc };

  Footprint footprint = Footprint::rectangle;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();   ///< unit vector along the first side
  Eigen::Vector2d half = Eigen::Vector2d::Zero();  ///< half sides; a disc has its radius twice [m]
  double bottom = 0.0;                             ///< [m]
  double top = 0.0;                                ///< [m]
  Material material = Material::ordinary;
};

/// Where the ray enters the obstacle, if it does within `max_range` [m]; at range 0 where it
/// starts inside.
std::optional<Hit> intersect(const Obstacle& obstacle, const Ray& ray, double max_range);

/// How far the point in the plane lies from the footprint; 0 inside [m].
double distance(const Obstacle& obstacle, const Eigen::Vector2d& p_map);

/// True where the footprint and the axis-parallel square share more than an edge.
/// `half_side` is half the side of the square [m].
bool overlaps(const Obstacle& obstacle, const Eigen::Vector2d& square_center, double half_side);

/// Half the sides of the smallest axis-parallel rectangle about the footprint [m].
Eigen::Vector2d half_extent(const Obstacle& obstacle);

}  // namespace portolan::sim
