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
  look_up_ranges(scan, options);
  place_ends(T_map_sensor, options);
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
  const std::size_t n = scan.ranges.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (is_rim_[i]) footprint.outline(end(i), end(i + 1 < n ? i + 1 : 0));
    if (is_echo_[i]) footprint.occupy(end(i));
  }
  return Result::drawn;
}

void ScanFan::look_up_directions(const RangeScan& scan) {
  if (angle_min_ == scan.angle_min && angle_increment_ == scan.angle_increment &&
      direction_x_.size() == scan.ranges.size()) {
    return;
  }
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  half_cosine_ = std::cos(scan.angle_increment / 2.0);
  half_sine_ = std::sin(scan.angle_increment / 2.0);
  direction_x_.resize(scan.ranges.size());
  direction_y_.resize(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    direction_x_[i] = std::cos(angle);
    direction_y_[i] = std::sin(angle);
  }
}

void ScanFan::look_up_ranges(const RangeScan& scan, const GridOptions& options) {
  const LaserModel& model = options.laser;
  least_range_ = options.resolution / 32.0;
  const double no_return =
      model.no_return == NoReturn::clear ? std::min(model.max_range, scan.range_max) : 0.0;
  const double nearest = std::max(scan.range_min, std::numeric_limits<double>::min());
  const double farthest = scan.range_min < scan.range_max ? scan.range_max : 0.0;
  range_.resize(scan.ranges.size());
  is_echo_.resize(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    double range = static_cast<double>(scan.ranges[i]);
    const bool is_hit = range >= nearest && range < farthest;
    is_echo_[i] = is_hit && range <= model.max_range;
    if (!is_hit) {
      const RangeReading reading = range_reading(range, scan.range_min, scan.range_max);
      range = reading == RangeReading::nothing_returned ? no_return : 0.0;
    }
    range_[i] = std::min(range, model.max_range);
  }
}

void ScanFan::place_ends(const Pose& T_map_sensor, const GridOptions& options) {
  grid_ = FineGrid(options.resolution);
  R_ = T_map_sensor.linear().topLeftCorner<2, 2>();
  turn_ = std::copysign(1.0, angle_increment_ * R_.determinant());
  const double xx = R_(0, 0), xy = R_(0, 1), yx = R_(1, 0), yy = R_(1, 1);
  const std::size_t n = range_.size();
  end_x_.resize(n);
  end_y_.resize(n);
  FinePoint min, max;
  for (std::size_t i = 0; i < n; ++i) {
    const FinePoint p = grid_.point(range_[i] * (xx * direction_x_[i] + xy * direction_y_[i]),
                                    range_[i] * (yx * direction_x_[i] + yy * direction_y_[i]));
    end_x_[i] = p.x;
    end_y_[i] = p.y;
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  bounds_ = {min, max};
}

// Inside the outline sectors share their sides, so only rims and the ends of chains remain of them.
void ScanFan::make_outline(const RangeScan& scan) {
  const std::size_t n = scan.ranges.size();
  const bool round = goes_round_once(scan);
  const double fitting = (2.0 * M_PI - kGap) / std::abs(scan.angle_increment) - 1.0;
  outlined_ = round ? n : std::min(n, static_cast<std::size_t>(std::max(0.0, fitting)));
  outline_.clear();
  is_rim_.assign(n, 0);
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
  if (i < outlined_ && next < outlined_) {
    is_rim_[i] = 1;
    return check_rim(end(i), end(next));
  }
  overlapping_.push_back({end(i), end(next)});
  if (i < outlined_) outline_.push_back({end(i), kSensor});
}

void ScanFan::add_half(std::size_t i, double side) {
  const double x = direction_x_[i] * half_cosine_ - direction_y_[i] * side;
  const double y = direction_y_[i] * half_cosine_ + direction_x_[i] * side;
  const FinePoint corner = grid_.point(range_[i] * (R_(0, 0) * x + R_(0, 1) * y),
                                       range_[i] * (R_(1, 0) * x + R_(1, 1) * y));
  bounds_.add(corner);
  const bool is_first = side * half_sine_ < 0.0;
  if (i >= outlined_) return overlapping_.push_back({end(i), corner});
  check_rim(is_first ? corner : end(i), is_first ? end(i) : corner);
  outline_.push_back({end(i), corner});
  outline_.push_back({corner, kSensor});
}

void ScanFan::check_rim(FinePoint a, FinePoint b) {
  if (static_cast<double>(cross(a, b)) * turn_ < 0.0) is_simple_ = false;
}

}  // namespace portolan
