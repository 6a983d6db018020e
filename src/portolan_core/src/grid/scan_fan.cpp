// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/scan_fan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

// What is left open of a turn at least, so that rounding cannot make its ends overlap [rad].
constexpr double kGap = 0.1;

constexpr FinePoint kSensor{0, 0};

bool goes_round_once(const RangeScan& scan) {
  const double step = std::abs(scan.angle_increment);
  return scan.ranges.size() > 2 &&
         std::abs(static_cast<double>(scan.ranges.size()) * step - 2.0 * M_PI) < 1e-3 * step;
}

std::int64_t cross(FinePoint a, FinePoint b) {
  return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

}  // namespace

ScanFan::Result ScanFan::draw(const RangeScan& scan, const Pose& T_map_sensor,
                              const GridOptions& options, Footprint& footprint) {
  if (std::abs(scan.angle_increment) > M_PI / 2.0) return Result::not_simple;
  look_up_directions(scan);
  place_ends(scan, T_map_sensor, options);
  make_outline(scan);
  if (!is_simple_) return Result::not_simple;
  if (!footprint.open(grid_.anchor(T_map_sensor.translation()), bounds_.min, bounds_.max)) {
    return Result::too_large;
  }
  for (const Edge& sector : overlapping_) {
    const std::array<FinePoint, 3> corners = {kSensor, sector.a, sector.b};
    footprint.fill(corners.data(), 3);
  }
  for (const Edge& edge : outline_) footprint.outline(edge.a, edge.b);
  for (const FinePoint& echo : echoes_) footprint.occupy(echo);
  return Result::drawn;
}

void ScanFan::look_up_directions(const RangeScan& scan) {
  if (angle_min_ == scan.angle_min && angle_increment_ == scan.angle_increment &&
      directions_.size() == scan.ranges.size()) {
    return;
  }
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  half_cosine_ = std::cos(scan.angle_increment / 2.0);
  half_sine_ = std::sin(scan.angle_increment / 2.0);
  directions_.resize(scan.ranges.size());
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    directions_[i] = {std::cos(angle), std::sin(angle)};
  }
}

void ScanFan::place_ends(const RangeScan& scan, const Pose& T_map_sensor,
                         const GridOptions& options) {
  R_ = T_map_sensor.linear().topLeftCorner<2, 2>();
  turn_ = std::copysign(1.0, scan.angle_increment * R_.determinant());
  grid_ = FineGrid(options.resolution);
  const double least = options.resolution / 32.0;
  const LaserModel& model = options.laser;
  const double no_return =
      model.no_return == NoReturn::clear ? std::min(model.max_range, scan.range_max) : 0.0;
  const bool tells_ranges = scan.range_min < scan.range_max;
  const double nearest = std::max(scan.range_min, std::numeric_limits<double>::min());
  const double farthest = tells_ranges ? scan.range_max : 0.0;
  const std::size_t n = scan.ranges.size();
  free_range_.resize(n);
  ends_.resize(n);
  echoes_.clear();
  bounds_ = {};
  for (std::size_t i = 0; i < n; ++i) {
    double range = static_cast<double>(scan.ranges[i]);
    const bool hit = range >= nearest && range < farthest;
    const bool echo = hit && range <= model.max_range;
    if (!hit) {
      const bool nothing =
          range_reading(range, scan.range_min, scan.range_max) == RangeReading::nothing_returned;
      range = nothing ? no_return : 0.0;
    }
    range = std::min(range, model.max_range);
    const Direction& u = directions_[i];
    ends_[i] = grid_.point(range * (R_(0, 0) * u.x + R_(0, 1) * u.y),
                           range * (R_(1, 0) * u.x + R_(1, 1) * u.y));
    bounds_.add(ends_[i]);
    if (echo) echoes_.push_back(ends_[i]);
    free_range_[i] = range < least ? 0.0 : range;
  }
}

// Inside the outline sectors share their sides, so only rims and the ends of chains remain of them.
void ScanFan::make_outline(const RangeScan& scan) {
  const std::size_t n = scan.ranges.size();
  const bool round = goes_round_once(scan);
  const double fitting = (2.0 * M_PI - kGap) / std::abs(scan.angle_increment) - 1.0;
  outlined_ = round ? n : std::min(n, static_cast<std::size_t>(std::max(0.0, fitting)));
  outline_.clear();
  overlapping_.clear();
  is_simple_ = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (!frees(i)) continue;
    const std::size_t previous = i > 0 ? i - 1 : n - 1;
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    if (!(frees(previous) && (i > 0 || round))) add_half(i, -half_sine_);
    if (frees(next) && (next > 0 || round)) {
      add_between(i, next);
    } else {
      add_half(i, half_sine_);
    }
  }
}

void ScanFan::add_between(std::size_t i, std::size_t next) {
  if (i < outlined_ && next < outlined_) return add_rim(ends_[i], ends_[next]);
  overlapping_.push_back({ends_[i], ends_[next]});
  if (i < outlined_) outline_.push_back({ends_[i], kSensor});
}

void ScanFan::add_half(std::size_t i, double side) {
  const Direction& u = directions_[i];
  const double x = u.x * half_cosine_ - u.y * side;
  const double y = u.y * half_cosine_ + u.x * side;
  const FinePoint corner = grid_.point(free_range_[i] * (R_(0, 0) * x + R_(0, 1) * y),
                                       free_range_[i] * (R_(1, 0) * x + R_(1, 1) * y));
  bounds_.add(corner);
  const bool is_first = side * half_sine_ < 0.0;
  if (i >= outlined_) return overlapping_.push_back({ends_[i], corner});
  add_rim(is_first ? corner : ends_[i], is_first ? ends_[i] : corner);
  outline_.push_back({corner, kSensor});
}

void ScanFan::add_rim(FinePoint a, FinePoint b) {
  outline_.push_back({a, b});
  if (static_cast<double>(cross(a, b)) * turn_ < 0.0) is_simple_ = false;
}

}  // namespace portolan
