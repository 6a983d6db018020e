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
  void look_up_directions(const RangeScan& scan);
  void look_up_ranges(const RangeScan& scan, const GridOptions& options);
  void place_ends(const Pose& T_map_sensor, const GridOptions& options);
  void make_outline(const RangeScan& scan);
  void add_between(std::size_t i, std::size_t next);
  void add_half(std::size_t i, double side);
  void check_rim(FinePoint a, FinePoint b);
  bool frees(std::size_t i) const { return range_[i] >= least_range_; }
  FinePoint end(std::size_t i) const { return {end_x_[i], end_y_[i]}; }

  // Directions of the beams, of the scan that they were made for.
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<double> direction_x_;
  std::vector<double> direction_y_;

  // Of the scan at hand.
  FineGrid grid_{1.0};
  Eigen::Matrix2d R_ = Eigen::Matrix2d::Identity();  // turns and projects
  double half_cosine_ = 1.0;                         // of half a step
  double half_sine_ = 0.0;
  double turn_ = 1.0;          // +1 where beams follow counter-clockwise in the map, else -1
  std::vector<double> range_;  // [m]; 0: says nothing
  double least_range_ = 0.0;   // what frees less than this frees nothing [m]
  std::vector<std::uint8_t> is_echo_;
  std::vector<std::int32_t> end_x_;
  std::vector<std::int32_t> end_y_;
  std::vector<std::uint8_t> is_rim_;  // from this beam to the next one runs the outline
  std::vector<Edge> outline_;         // the rest of it: where chains of sectors end
  std::vector<Edge> overlapping_;     // sectors that may lie upon those within the outline
  std::size_t outlined_ = 0;          // so many beams are in the outline
  FineBounds bounds_;
  bool is_simple_ = true;  // no sector of the outline lies upon another one
};

}  // namespace portolan
