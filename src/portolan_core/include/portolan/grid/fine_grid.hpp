// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "portolan/grid/footprint.hpp"

namespace portolan {

/// Rounds metres in the map to the footprint's fine grid.
class FineGrid {
 public:
  explicit FineGrid(double resolution) : fine_per_metre_(Footprint::kFine / resolution) {}

  double scale() const { return fine_per_metre_; }

  Footprint::Anchor anchor(const Eigen::Vector3d& p_map) const {
    return {nearest<std::int64_t>(p_map.x() * fine_per_metre_),
            nearest<std::int64_t>(p_map.y() * fine_per_metre_)};
  }

  /// A point so far from its anchor [m], and one coordinate of it.
  FinePoint point(double x, double y) const { return {coordinate(x), coordinate(y)}; }
  std::int32_t coordinate(double metres) const {
    return nearest<std::int32_t>(metres * fine_per_metre_);
  }

  std::int64_t length(double metres) const {
    return nearest<std::int64_t>(metres * fine_per_metre_);
  }

 private:
  template <class Integer>
  static Integer nearest(double value) {
    return static_cast<Integer>(value + std::copysign(0.5, value));
  }

  double fine_per_metre_;
};

/// The rectangle around points that are counted from one anchor.
struct FineBounds {
  FinePoint min{0, 0};
  FinePoint max{0, 0};

  void add(FinePoint p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
};

}  // namespace portolan
