// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "portolan/grid/chain_edges.hpp"
#include "portolan/grid/fine_grid.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// The beams of a scan, seen from above: what each says, and where, in the footprint's fine grid.
class ScanBeams {
 public:
  /// Joined sectors are at most so wide, and so are those without neighbours [rad].
  static constexpr double kWidest = M_PI / 2.0;

  /// Makes the beams of a usable scan. Points count from the place of the first beam's sensor.
  void place(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options);

  std::size_t size() const { return range_.size(); }
  bool frees(std::size_t i) const { return frees_[i] != 0; }
  const std::vector<std::uint8_t>& frees() const { return frees_; }  ///< and the first once more
  bool hits(std::size_t i) const { return hit_[i] > 0.0; }

  FinePoint origin(std::size_t i) const;                     ///< of the beam
  FinePoint end(std::size_t i) const { return end_.at(i); }  ///< of what it frees
  const FinePoints& ends() const { return end_; }            ///< and the first one once more
  FinePoint echo(std::size_t i) const { return has_margin_ ? echo_.at(i) : end_.at(i); }
  FinePoint far(std::size_t i) const { return far_.at(i); }  ///< the margin beyond the echo
  FinePoint beside(std::size_t i, double side) const;  ///< of the end, `side` half steps further on

  /// Where the sensor stood, for all sectors: half way between the first and the last beam.
  FinePoint centre() const { return centre_; }

  /// The rectangle around all these points.
  const FineBounds& bounds() const { return bounds_; }

  /// Do both hit one surface, as far as their ranges tell?
  bool is_one_surface(std::size_t i, std::size_t j) const {
    return hits(i) && hits(j) && frees(i) && frees(j) && std::abs(hit_[i] - hit_[j]) <= same_;
  }

  const FineGrid& grid() const { return grid_; }
  bool has_margin() const { return has_margin_; }
  bool is_swept() const { return is_swept_; }
  bool may_join() const { return may_join_; }  ///< Is a step at most kWidest?

  /// So many beams from the first one on lie within one turn of the sensor.
  std::size_t first_turn() const { return first_turn_; }
  /// Is the first beam the last one's neighbour?
  bool is_round() const { return is_round_; }

 private:
  void look_up_directions(const RangeScan& scan);
  void look_up_ranges(const RangeScan& scan, const GridOptions& options);
  void turn_directions();
  void sweep(const RangeScan& scan, const Pose& T_map_sensor);
  void count_turn(const RangeScan& scan);
  void put(const std::vector<double>& range, FinePoints& points);

  // Directions of the beams, of the scan that they were made for.
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<double> direction_x_;
  std::vector<double> direction_y_;
  double half_cosine_ = 1.0;  // of half a step
  double half_sine_ = 0.0;

  // Of the scan at hand.
  FineGrid grid_{1.0};
  bool has_margin_ = false;
  bool is_swept_ = false;
  bool may_join_ = false;
  bool is_round_ = false;
  std::size_t first_turn_ = 0;
  double same_ = 0.0;  // what ranges of one surface differ by at most [m]
  Eigen::Matrix2d R_ = Eigen::Matrix2d::Identity();  // turns and projects, at the first beam
  std::vector<Eigen::Matrix2d> R_swept_;             // at each beam, where it moves
  FinePoint centre_;
  FineBounds bounds_;
  std::vector<double> range_;        // that is free [m]; 0: says nothing
  std::vector<std::uint8_t> frees_;  // is that more than nothing?
  std::vector<double> hit_;          // of the echo [m]; 0: none
  std::vector<double> beyond_;
  std::vector<double> map_x_;  // directions in the map
  std::vector<double> map_y_;
  FinePoints origin_;
  FinePoints end_;
  FinePoints echo_;
  FinePoints far_;
};

}  // namespace portolan
