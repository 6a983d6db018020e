// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace portolan::sim {

namespace {

constexpr double kSide = 0.5;  // of a cell [m]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The walk of a ray from cell to cell (Amanatides and Woo): for each axis the direction, the range
/// at which the next border is crossed, and the range from border to border.
struct Walk {
  Eigen::Vector2i step;
  Eigen::Vector2d next;
  Eigen::Vector2d stride;
};

Walk walk_from(const Eigen::Vector2i& cell, const Eigen::Vector2d& corner, const Ray& ray) {
  Walk walk;
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = ray.direction[axis];
    walk.step[axis] = speed > 0.0 ? 1 : -1;
    const double border = corner[axis] + kSide * (cell[axis] + (speed > 0.0 ? 1 : 0));
    walk.next[axis] = speed == 0.0 ? kInfinity : (border - ray.origin[axis]) / speed;
    walk.stride[axis] = speed == 0.0 ? kInfinity : kSide / std::abs(speed);
  }
  return walk;
}

/// The ranges at which the ray enters and leaves the rectangle; enter > leave where it misses it.
std::pair<double, double> span_inside(const Ray& ray, const Eigen::AlignedBox2d& area) {
  double enter = 0.0;
  double leave = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = ray.direction[axis];
    const double to_min = area.min()[axis] - ray.origin[axis];
    const double to_max = area.max()[axis] - ray.origin[axis];
    if (speed == 0.0) {
      if (to_min > 0.0 || to_max < 0.0) leave = -kInfinity;
      continue;
    }
    enter = std::max(enter, std::min(to_min / speed, to_max / speed));
    leave = std::min(leave, std::max(to_min / speed, to_max / speed));
  }
  return {enter, leave};
}

}  // namespace

RayCaster::RayCaster(std::vector<Obstacle> obstacles) : obstacles_(std::move(obstacles)) {
  size_grid();
  list_obstacles();
}

void RayCaster::size_grid() {
  Eigen::AlignedBox2d area;
  for (const Obstacle& obstacle : obstacles_) {
    area.extend(Eigen::Vector2d(obstacle.center - half_extent(obstacle)));
    area.extend(Eigen::Vector2d(obstacle.center + half_extent(obstacle)));
  }
  if (area.isEmpty()) return;
  corner_ = area.min().array() - 0.5 * kSide;
  const Eigen::Vector2d cells = (area.max() - corner_).array() / kSide + 0.5;
  size_ = cells.array().ceil().cast<int>();
}

void RayCaster::list_obstacles() {
  std::vector<std::vector<Index>> lists(static_cast<std::size_t>(size_.x()) *
                                        static_cast<std::size_t>(size_.y()));
  for (Index i = 0; i < obstacles_.size(); ++i) {
    const Eigen::AlignedBox2i cells = cells_about(obstacles_[i].center, half_extent(obstacles_[i]));
    for (int y = cells.min().y(); y <= cells.max().y(); ++y) {
      for (int x = cells.min().x(); x <= cells.max().x(); ++x) {
        const Eigen::Vector2d center = corner_ + kSide * Eigen::Vector2d(x + 0.5, y + 0.5);
        constexpr double kMargin = 1e-6;  // a ray along a border may be in either cell
        if (overlaps(obstacles_[i], center, 0.5 * kSide + kMargin)) {
          lists[slot({x, y})].push_back(i);
        }
      }
    }
  }
  first_.assign(1, 0);
  for (const std::vector<Index>& list : lists) {
    listed_.insert(listed_.end(), list.begin(), list.end());
    first_.push_back(static_cast<Index>(listed_.size()));
  }
}

RayCaster::Cell RayCaster::cell_of(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d cell = ((p_map - corner_) / kSide).array().floor();
  return cell.cast<int>().cwiseMax(0).cwiseMin(size_ - Cell::Ones());
}

std::size_t RayCaster::slot(const Cell& cell) const {
  return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(size_.x()) +
         static_cast<std::size_t>(cell.x());
}

Eigen::AlignedBox2i RayCaster::cells_about(const Eigen::Vector2d& center,
                                           const Eigen::Vector2d& half) const {
  return {cell_of(center - half), cell_of(center + half)};
}

void RayCaster::cast_in_cell(const Cell& cell, const Ray& ray, Wave wave,
                             std::optional<Hit>& nearest, double& range) const {
  const std::size_t at = slot(cell);
  for (Index i = first_[at]; i < first_[at + 1]; ++i) {
    const Obstacle& obstacle = obstacles_[listed_[i]];
    if (passes(wave, obstacle.material)) continue;
    const std::optional<Hit> hit = intersect(obstacle, ray, range);
    if (!hit || (nearest && hit->range >= range)) continue;
    nearest = hit;
    range = hit->range;
  }
}

std::optional<Hit> RayCaster::cast(const Ray& ray, Wave wave, double max_range) const {
  const Eigen::AlignedBox2d area(corner_, Eigen::Vector2d(corner_ + kSide * size_.cast<double>()));
  const auto [enter, leave] = span_inside(ray, area);
  if (enter > std::min(leave, max_range)) return std::nullopt;
  Cell cell = cell_of((ray.origin + enter * ray.direction).head<2>());
  Walk walk = walk_from(cell, corner_, ray);
  std::optional<Hit> nearest;
  double range = max_range;
  while (true) {
    cast_in_cell(cell, ray, wave, nearest, range);
    const int axis = walk.next.x() < walk.next.y() ? 0 : 1;
    if (walk.next[axis] >= range) return nearest;
    cell[axis] += walk.step[axis];
    walk.next[axis] += walk.stride[axis];
    if (cell[axis] < 0 || cell[axis] >= size_[axis]) return nearest;
  }
}

double RayCaster::clearance(const Eigen::Vector2d& p_map, double reach, double bottom,
                            double top) const {
  const Eigen::AlignedBox2i cells = cells_about(p_map, Eigen::Vector2d::Constant(reach));
  double nearest = reach;
  for (int y = cells.min().y(); y <= cells.max().y(); ++y) {
    for (int x = cells.min().x(); x <= cells.max().x(); ++x) {
      const std::size_t at = slot({x, y});
      for (Index i = first_[at]; i < first_[at + 1]; ++i) {
        const Obstacle& obstacle = obstacles_[listed_[i]];
        if (obstacle.bottom >= top || obstacle.top <= bottom) continue;
        nearest = std::min(nearest, distance(obstacle, p_map));
      }
    }
  }
  return nearest;
}

}  // namespace portolan::sim
