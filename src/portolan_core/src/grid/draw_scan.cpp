// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "portolan/grid/draw.hpp"
#include "portolan/grid/fine_grid.hpp"
#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

// Wedges wider than this are not joined to their neighbours, nor made wider [rad].
constexpr double kWidest = M_PI / 2.0;

bool is_tilted(const Pose& T_map_sensor, const GridOptions& options) {
  return std::abs(T_map_sensor(2, 2)) < std::cos(options.max_tilt);
}

bool may_be_fan(const RangeScan& scan, const GridOptions& options) {
  return options.laser.beam_model == BeamModel::sector && options.laser.margin == 0.0 &&
         scan.T_first_last.matrix() == Pose::Identity().matrix();
}

// One beam, seen from above.
struct Beam {
  FinePoint origin;         // from the anchor
  Eigen::Matrix2d R;        // turns and projects the scan's plane into the map's
  double angle = 0.0;       // in the scan's plane [rad]
  double free_range = 0.0;  // [m]; 0: says nothing about free space
  double hit_range = 0.0;   // [m]; 0: no echo
  FinePoint free_end;
  FinePoint echo;

  bool frees() const { return free_range > 0.0; }
  bool hits() const { return hit_range > 0.0; }
};

class ScanModel {
 public:
  ScanModel(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options)
      : scan_(scan),
        options_(options),
        grid_(options.resolution),
        T_map_first_(T_map_sensor),
        anchor_(grid_.anchor(T_map_sensor.translation())),
        is_swept_(scan.T_first_last.matrix() != Pose::Identity().matrix()),
        half_step_(std::min(std::abs(scan.angle_increment), kWidest) / 2.0 *
                   (scan.angle_increment > 0.0 ? 1.0 : -1.0)) {}

  Outcome draw(Footprint& footprint) {
    if (is_tilted(T_map_first_, options_)) return Outcome::rejected;
    if (is_swept_ && is_tilted(T_map_first_ * scan_.T_first_last, options_)) {
      return Outcome::rejected;
    }
    make_beams();
    if (!footprint.open(anchor_, bounds_.min, bounds_.max)) return Outcome::unusable;
    if (options_.laser.beam_model == BeamModel::ray) {
      draw_rays(footprint);
    } else {
      draw_sectors(footprint);
    }
    draw_echoes(footprint);
    return Outcome::inserted;
  }

 private:
  FinePoint at(const Beam& beam, double angle, double range) const {
    const Eigen::Vector2d p = range * (beam.R * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    const FinePoint fine = grid_.point(p.x(), p.y());
    return {beam.origin.x + fine.x, beam.origin.y + fine.y};
  }

  void make_beams() {
    beams_.resize(scan_.ranges.size());
    const double last = std::max(1.0, static_cast<double>(beams_.size() - 1));
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      Beam& beam = beams_[i];
      place(beam, static_cast<double>(i) / last);
      beam.angle = scan_.angle_min + static_cast<double>(i) * scan_.angle_increment;
      believe(beam, static_cast<double>(scan_.ranges[i]));
      bounds_.add(beam.origin);
      if (beam.frees()) {
        beam.free_end = at(beam, beam.angle, beam.free_range);
        bounds_.add(beam.free_end);
        bounds_.add(at(beam, beam.angle - half_step_, beam.free_range));
        bounds_.add(at(beam, beam.angle + half_step_, beam.free_range));
      }
      if (!beam.hits()) continue;
      beam.echo = at(beam, beam.angle, beam.hit_range);
      bounds_.add(beam.echo);
      if (options_.laser.margin > 0.0) {
        bounds_.add(at(beam, beam.angle - half_step_, beam.hit_range + options_.laser.margin));
        bounds_.add(at(beam, beam.angle + half_step_, beam.hit_range + options_.laser.margin));
        bounds_.add(at(beam, beam.angle, beam.hit_range + options_.laser.margin));
      }
    }
  }

  void place(Beam& beam, double fraction) const {
    const Pose T = is_swept_
                       ? interpolate(T_map_first_, T_map_first_ * scan_.T_first_last, fraction)
                       : T_map_first_;
    beam.R = T.linear().topLeftCorner<2, 2>();
    const Eigen::Vector3d moved = T.translation() - T_map_first_.translation();
    beam.origin = grid_.point(moved.x(), moved.y());
  }

  void believe(Beam& beam, double range) const {
    const LaserModel& model = options_.laser;
    switch (range_reading(range, scan_.range_min, scan_.range_max)) {
      case RangeReading::no_information:
        return;
      case RangeReading::nothing_returned:
        if (model.no_return == NoReturn::clear) {
          beam.free_range = std::min(model.max_range, scan_.range_max);
        }
        break;
      case RangeReading::hit:
        beam.free_range = std::min(range - model.margin, model.max_range);
        if (range <= model.max_range) beam.hit_range = range;
        break;
    }
    if (beam.free_range * 32.0 < options_.resolution) beam.free_range = 0.0;
  }

  void draw_rays(Footprint& footprint) const {
    for (const Beam& beam : beams_) {
      if (beam.frees()) footprint.ray(beam.origin, beam.free_end);
    }
  }

  void draw_sectors(Footprint& footprint) const {
    const bool joined = std::abs(scan_.angle_increment) <= kWidest;
    const std::size_t n = beams_.size();
    const bool closed = std::abs(static_cast<double>(n) * std::abs(scan_.angle_increment) -
                                 2.0 * M_PI) < 1e-3 * std::abs(scan_.angle_increment);
    for (std::size_t i = 0; i < n; ++i) {
      const Beam& beam = beams_[i];
      if (!beam.frees()) continue;
      const bool wraps = closed && joined && n > 2;
      const Beam* next = i + 1 < n ? &beams_[i + 1] : wraps ? &beams_[0] : nullptr;
      const Beam* previous = i > 0 ? &beams_[i - 1] : wraps ? &beams_[n - 1] : nullptr;
      if (joined && next && next->frees()) {
        fill_between(beam, *next, footprint);
      } else {
        fill_half(beam, half_step_, footprint);
      }
      if (!(joined && previous && previous->frees())) fill_half(beam, -half_step_, footprint);
    }
  }

  static void fill_between(const Beam& a, const Beam& b, Footprint& footprint) {
    const std::array<FinePoint, 4> corners = {a.origin, a.free_end, b.free_end, b.origin};
    footprint.fill(corners.data(), 4);
  }

  void fill_half(const Beam& beam, double side, Footprint& footprint) const {
    const std::array<FinePoint, 3> corners = {beam.origin, beam.free_end,
                                              at(beam, beam.angle + side, beam.free_range)};
    footprint.fill(corners.data(), 3);
  }

  void draw_echoes(Footprint& footprint) const {
    const double d = options_.laser.margin;
    for (const Beam& beam : beams_) {
      if (!beam.hits()) continue;
      footprint.occupy(beam.echo);
      if (d == 0.0) continue;
      const std::array<FinePoint, 4> corners = {
          at(beam, beam.angle - half_step_, std::max(0.0, beam.hit_range - d)),
          at(beam, beam.angle - half_step_, beam.hit_range + d),
          at(beam, beam.angle + half_step_, beam.hit_range + d),
          at(beam, beam.angle + half_step_, std::max(0.0, beam.hit_range - d))};
      footprint.fill_occupied(corners.data(), 4);
    }
  }

  const RangeScan& scan_;
  const GridOptions& options_;
  FineGrid grid_;
  Pose T_map_first_;
  Footprint::Anchor anchor_;
  bool is_swept_;
  double half_step_;
  std::vector<Beam> beams_;
  FineBounds bounds_;
};

}  // namespace

Outcome draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
             ScanFan& fan, Footprint& footprint) {
  if (!is_usable(scan)) return Outcome::unusable;
  if (may_be_fan(scan, options)) {
    if (is_tilted(T_map_sensor, options)) return Outcome::rejected;
    switch (fan.draw(scan, T_map_sensor, options, footprint)) {
      case ScanFan::Result::drawn:
        return Outcome::inserted;
      case ScanFan::Result::too_large:
        return Outcome::unusable;
      case ScanFan::Result::not_simple:
        break;
    }
  }
  return ScanModel(scan, T_map_sensor, options).draw(footprint);
}

}  // namespace portolan
