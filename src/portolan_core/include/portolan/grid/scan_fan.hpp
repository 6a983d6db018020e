// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "portolan/grid/fine_grid.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// Draws the sectors of a scan from one place as the outline of the whole visible region, which
/// takes a small part of the time of drawing sector by sector, and gives the same cells.
class ScanFan {
 public:
  enum class Result {
    drawn,
    too_large,   ///< for any footprint
    not_simple,  ///< sectors might overlap: they must be drawn one by one
  };

  /// A scan without motion, for options with sectors and without margin.
  Result draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
              Footprint& footprint);

 private:
  struct Edge {
    FinePoint a;
    FinePoint b;  // with the sensor they are the corners of a sector
  };
  struct Direction {
    double x;
    double y;
  };

  void look_up_directions(const RangeScan& scan);
  void place_ends(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options);
  void make_outline(const RangeScan& scan);
  void add_between(std::size_t i, std::size_t next);
  void add_half(std::size_t i, double side);
  void add_rim(FinePoint a, FinePoint b);
  bool frees(std::size_t i) const { return free_range_[i] > 0.0; }

  // Directions of the beams, of the scan that they were made for.
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<Direction> directions_;

  // Of the scan at hand.
  FineGrid grid_{1.0};
  Eigen::Matrix2d R_ = Eigen::Matrix2d::Identity();  // turns and projects
  double half_cosine_ = 1.0;                         // of half a step
  double half_sine_ = 0.0;
  double turn_ = 1.0;               // +1 where beams follow counter-clockwise in the map, else -1
  std::vector<double> free_range_;  // [m]
  std::vector<FinePoint> ends_;
  std::vector<FinePoint> echoes_;
  std::vector<Edge> outline_;
  std::vector<Edge> overlapping_;  // sectors that may lie upon those within the outline
  std::size_t outlined_ = 0;       // so many beams are in the outline
  FineBounds bounds_;
  bool is_simple_ = true;  // no sector of the outline lies upon another one
};

}  // namespace portolan
