// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/score_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace portolan {

namespace {

// A graph that somebody bent apart must not take all memory: no scanner reaches so far.
std::vector<Eigen::Vector3d> within_reach(const std::vector<Eigen::Vector3d>& points,
                                          double resolution) {
  constexpr double kReach = 4096.0;  // [cell]
  std::vector<Eigen::Vector3d> near;
  std::copy_if(points.begin(), points.end(), std::back_inserter(near),
               [&](const Eigen::Vector3d& p) {
                 return (p.head<2>().array().abs() <= kReach * resolution).all();
               });
  return near;
}

}  // namespace

ScorePyramid::ScorePyramid(const std::vector<Eigen::Vector3d>& points, double resolution,
                           double blur, int levels)
    : resolution_(resolution) {
  const std::vector<Eigen::Vector3d> near = within_reach(points, resolution);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : near) box.extend(p.head<2>());
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero());
  const int rim = (1 << (levels - 1)) + 1 + static_cast<int>(std::ceil(3.0 * blur / resolution));
  const Eigen::Vector2d size = box.sizes() / resolution;
  origin_ = box.min().array() - (rim + 0.5) * resolution;
  width_ = static_cast<int>(std::ceil(size.x())) + 2 * rim + 1;
  height_ = static_cast<int>(std::ceil(size.y())) + 2 * rim + 1;
  draw(near, blur);
  for (int h = 1; h < levels; ++h) levels_.push_back(coarser(levels_.back(), 1 << (h - 1)));
}

ScorePyramid::Cell ScorePyramid::cell_of(const Eigen::Vector2d& p) const {
  const Eigen::Array2d cell = (p - origin_).array() / resolution_;
  return {static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y()))};
}

void ScorePyramid::draw(const std::vector<Eigen::Vector3d>& points, double blur) {
  const int reach = static_cast<int>(std::ceil(3.0 * blur / resolution_));
  const int side = 2 * reach + 1;
  std::vector<std::uint8_t> stamp;
  for (int i = 0; i < side * side; ++i) {
    const double d = std::hypot(i % side - reach, i / side - reach) * resolution_ / blur;
    stamp.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::exp(-0.5 * d * d))));
  }
  Level level(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  for (const Eigen::Vector3d& p : points) {
    const Cell corner = cell_of(p.head<2>()) - Cell(reach, reach);
    for (int y = 0; y < side; ++y) {
      const auto row =
          level.begin() + static_cast<std::ptrdiff_t>(index(corner.x(), corner.y() + y));
      const auto from = stamp.begin() + y * side;
      std::transform(from, from + side, row, row,
                     [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    }
  }
  levels_.push_back(std::move(level));
}

// Each cell becomes the best of itself and those `reach` to the right, above, and both.
ScorePyramid::Level ScorePyramid::coarser(const Level& fine, int reach) const {
  const auto better = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
  const auto stride = static_cast<std::ptrdiff_t>(width_);
  Level wide = fine;
  for (int y = 0; y < height_; ++y) {
    const auto row = fine.begin() + y * stride;
    std::transform(row, row + stride - reach, row + reach, wide.begin() + y * stride, better);
  }
  Level both = wide;
  std::transform(wide.begin(), wide.end() - reach * stride, wide.begin() + reach * stride,
                 both.begin(), better);
  return both;
}

}  // namespace portolan
