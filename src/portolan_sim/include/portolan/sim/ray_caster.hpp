// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "portolan/sim/obstacle.hpp"
#include "portolan/sim/ray.hpp"

namespace portolan::sim {

/// Finds what a ray meets first, quickly: obstacles are listed by the squares of a coarse grid, and
/// a ray asks only those whose squares it crosses.
class RayCaster {
 public:
  explicit RayCaster(std::vector<Obstacle> obstacles);

  /// The first surface on the ray within `max_range` [m] that the wave does not pass.
  std::optional<Hit> cast(const Ray& ray, Wave wave,
                          double max_range = std::numeric_limits<double>::infinity()) const;

  /// The distance in the plane to the nearest obstacle that reaches into heights from `bottom` to
  /// `top`, or `reach` where none is nearer [m].
  double clearance(const Eigen::Vector2d& p_map, double reach, double bottom, double top) const;

  const std::vector<Obstacle>& obstacles() const { return obstacles_; }

 private:
  using Index = std::uint32_t;
  using Cell = Eigen::Vector2i;

  void size_grid();
  void list_obstacles();
  Cell cell_of(const Eigen::Vector2d& p_map) const;
  std::size_t slot(const Cell& cell) const;
  Eigen::AlignedBox2i cells_about(const Eigen::Vector2d& center, const Eigen::Vector2d& half) const;
  void cast_in_cell(const Cell& cell, const Ray& ray, Wave wave, std::optional<Hit>& nearest,
                    double& range) const;

  std::vector<Obstacle> obstacles_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();  // lower left of the grid [m]
  Eigen::Vector2i size_ = Eigen::Vector2i::Ones();    // in cells
  std::vector<Index> first_;   // of each cell in listed_; one more at the end
  std::vector<Index> listed_;  // indices into obstacles_, cell by cell
};

}  // namespace portolan::sim
