// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace portolan {

/// How near surfaces are, over the plane and at several coarsenesses: the bounds by which a search
/// leaves out whole regions.
class ScorePyramid {
 public:
  using Cell = Eigen::Vector2i;

  /// Scores fall off by a Gaussian of deviation `blur` [m] around the points; cells have the side
  /// `resolution` [m]. Level h holds in each cell the best of the 2^h by 2^h cells from it on.
  /// Points over 4096 cells from the origin are left out.
  ScorePyramid(const std::vector<Eigen::Vector3d>& points, double resolution, double blur,
               int levels);

  /// The cell that holds the point; it need not be inside.
  Cell cell_of(const Eigen::Vector2d& p) const;

  /// 0 to 255; 0 outside.
  int score(int level, const Cell& cell) const {
    const bool inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < width_ && cell.y() < height_;
    return inside ? levels_[static_cast<std::size_t>(level)][index(cell.x(), cell.y())] : 0;
  }

  int levels() const { return static_cast<int>(levels_.size()); }
  double resolution() const { return resolution_; }

 private:
  using Level = std::vector<std::uint8_t>;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  void draw(const std::vector<Eigen::Vector3d>& points, double blur);
  Level coarser(const Level& fine, int reach) const;

  double resolution_;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  // corner of cell (0, 0) [m]
  int width_ = 0;
  int height_ = 0;
  std::vector<Level> levels_;
};

}  // namespace portolan
