// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/reference_region.hpp"
#include "portolan/grid/grid_mapper.hpp"

namespace portolan {

/// What a sensor says from one pose: the regions that it saw free or occupied, one by one.
class ReferenceView {
 public:
  /// Looks at once.
  ReferenceView(const GridOptions& options, const Pose& T_map_sensor,
                const GridMapper::Observation& z);

  const std::vector<ReferenceRegion>& regions() const { return regions_; }

  /// Where the regions' points are counted from: the sensor, in 1/1024 of a cell, in the map.
  ReferenceRegion::Point anchor() const { return anchor_; }

 private:
  using Point = ReferenceRegion::Point;
  using Shape = ReferenceRegion::Shape;
  struct Beam {
    Point origin;
    Eigen::Matrix2d R;
    double angle;
    double free = 0.0;
    double hit = 0.0;
  };

  void see(const RangeScan& scan);
  void see(const RangeEcho& echo);
  void see(const PointCloud& cloud);
  void see_side(const RangeScan& scan, const std::vector<Beam>& beams, std::size_t i,
                std::size_t neighbour, double half);
  void see_between(const RangeScan& scan, const std::vector<Beam>& beams, std::size_t i,
                   std::size_t next);
  static void add(ReferenceRegion& outline, const std::vector<Point>& polygon);
  void see_ray(Eigen::Vector3d ray, bool returned);

  Point at(double x, double y) const;
  Point end(const Beam& beam, double angle, double range) const;
  Beam beam(const RangeScan& scan, std::size_t i) const;
  std::vector<Point> rim(const RangeEcho& echo, double radius) const;

  GridOptions options_;
  Pose T_;
  double fine_;  // 1/1024 of a cell in a metre
  Point anchor_;
  Point centre_{};                                    // of the sectors of a scan
  ReferenceRegion outline_{Shape::edges, false, {}};  // of the sectors of the first turn
  ReferenceRegion strips_{Shape::edges, true, {}};    // beyond them
  std::vector<ReferenceRegion> regions_;
};

}  // namespace portolan
