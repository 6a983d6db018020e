// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/scan_beams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "portolan/grid/row_vectors.hpp"
#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

// What is left open of a turn at least, so that rounding cannot make its ends overlap [rad].
constexpr double kGap = 0.1;

bool goes_round_once(const RangeScan& scan) {
  const double step = std::abs(scan.angle_increment);
  return scan.ranges.size() > 2 &&
         std::abs(static_cast<double>(scan.ranges.size()) * step - 2.0 * M_PI) < 1e-3 * step;
}

// What the readings of a scan mean [m].
struct Limits {
  double nearest;    // from here on something stands there,
  double farthest;   // up to here,
  double usable;     // of use as an echo up to here;
  double silent;     // from here on nothing returned,
  double no_return;  // which frees so much
};

// As `range_reading` says, without a branch: what a range frees, its echo, and the margin beyond.
void read(const float* __restrict ranges, std::size_t n, const Limits& limits, double margin,
          double* __restrict free, double* __restrict hit, double* __restrict beyond) {
  const Limits m = limits;
  for (std::size_t i = 0; i < n; ++i) {
    const auto range = static_cast<double>(ranges[i]);
    const double near = range >= m.nearest ? range : 0.0;
    const double measured = range < m.farthest ? near : 0.0;  // 0: no hit
    const double echo = measured <= m.usable ? measured : 0.0;
    const double unseen = range >= m.silent ? m.no_return : 0.0;
    const double back = measured - margin;
    const double drawn_back = back > 0.0 ? back : 0.0;
    const double freed = measured > 0.0 ? drawn_back : unseen;
    hit[i] = echo;
    const double behind = echo + margin;
    beyond[i] = echo > 0.0 ? behind : 0.0;
    free[i] = freed < m.usable ? freed : m.usable;
  }
}

// Which ranges are so long at least?
void compare(const double* __restrict range, std::size_t n, double least,
             std::uint8_t* __restrict is_long) {
  for (std::size_t i = 0; i < n; ++i) is_long[i] = range[i] >= least ? 1 : 0;
}

// So many directions, seen from the map.
void turn(const Eigen::Matrix2d& R, std::size_t n, const double* __restrict x,
          const double* __restrict y, double* __restrict map_x, double* __restrict map_y) {
  const double xx = R(0, 0), xy = R(0, 1), yx = R(1, 0), yy = R(1, 1);
  for (std::size_t i = 0; i < n; ++i) {
    map_x[i] = xx * x[i] + xy * y[i];
    map_y[i] = yx * x[i] + yy * y[i];
  }
}

// One coordinate of points at these ranges in these directions.
void round(const FineGrid& to, std::size_t n, const double* __restrict range,
           const double* __restrict direction, std::int32_t* __restrict fine) {
  const FineGrid grid = to;
  for (std::size_t i = 0; i < n; ++i) fine[i] = grid.coordinate(range[i] * direction[i]);
}

FineBounds united(const FineBounds& with, const std::int32_t* x, const std::int32_t* y,
                  std::size_t n) {
  FineBounds bounds = with;
  for (std::size_t i = 0; i < n; ++i) bounds.add({x[i], y[i]});
  return bounds;
}

FinePoint operator+(FinePoint a, FinePoint b) { return {a.x + b.x, a.y + b.y}; }

}  // namespace

void ScanBeams::place(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options) {
  grid_ = FineGrid(options.resolution);
  R_ = T_map_sensor.linear().topLeftCorner<2, 2>();
  has_margin_ = options.laser.margin > 0.0;
  is_swept_ = scan.T_first_last.matrix() != Pose::Identity().matrix();
  look_up_directions(scan);
  look_up_ranges(scan, options);
  bounds_ = {};
  if (is_swept_) {
    sweep(scan, T_map_sensor);
  } else {
    turn_directions();
  }
  put(range_, end_);
  if (has_margin_) {
    put(hit_, echo_);
    put(beyond_, far_);
  }
  count_turn(scan);
}

void ScanBeams::look_up_directions(const RangeScan& scan) {
  if (angle_min_ == scan.angle_min && angle_increment_ == scan.angle_increment &&
      direction_x_.size() == scan.ranges.size()) {
    return;
  }
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  const double half =
      std::copysign(std::min(std::abs(angle_increment_), kWidest) / 2.0, angle_increment_);
  half_cosine_ = std::cos(half);
  half_sine_ = std::sin(half);
  direction_x_.resize(scan.ranges.size());
  direction_y_.resize(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    direction_x_[i] = std::cos(angle);
    direction_y_[i] = std::sin(angle);
  }
}

void ScanBeams::look_up_ranges(const RangeScan& scan, const GridOptions& options) {
  const LaserModel& model = options.laser;
  const double d = model.margin;
  same_ = 2.0 * d + options.resolution;
  const std::size_t n = scan.ranges.size();
  range_.resize(n);
  frees_.resize(n + 1);
  hit_.resize(n);
  beyond_.resize(n);
  const bool measures = scan.range_min < scan.range_max;
  Limits limits;
  limits.nearest = std::max(scan.range_min, std::numeric_limits<double>::min());
  limits.farthest = measures ? scan.range_max : 0.0;
  limits.silent = measures ? scan.range_max : std::numeric_limits<double>::infinity();
  limits.usable = model.max_range;
  limits.no_return =
      model.no_return == NoReturn::clear ? std::min(model.max_range, scan.range_max) : 0.0;
  with_widest_rows([&](auto) {
    read(scan.ranges.data(), n, limits, d, range_.data(), hit_.data(), beyond_.data());
    compare(range_.data(), n, options.resolution / 32.0, frees_.data());
  });
  frees_[n] = frees_[0];
}

void ScanBeams::turn_directions() {
  const std::size_t n = range_.size();
  map_x_.resize(n);
  map_y_.resize(n);
  with_widest_rows([&](auto) {
    turn(R_, n, direction_x_.data(), direction_y_.data(), map_x_.data(), map_y_.data());
  });
  centre_ = {};
}

// The sensor moves from the first beam to the last one, evenly in place and angle.
void ScanBeams::sweep(const RangeScan& scan, const Pose& T_map_sensor) {
  const std::size_t n = range_.size();
  const double last = std::max(1.0, static_cast<double>(n - 1));
  const Eigen::Vector2d moved = (T_map_sensor.linear() * scan.T_first_last.translation()).head<2>();
  const Eigen::AngleAxisd turned(scan.T_first_last.linear());
  // Rodrigues: R = I + sin(a) K + (1 - cos(a)) K^2, seen from above.
  Eigen::Matrix3d K;
  K << 0.0, -turned.axis().z(), turned.axis().y(), turned.axis().z(), 0.0, -turned.axis().x(),
      -turned.axis().y(), turned.axis().x(), 0.0;
  const Eigen::Matrix3d R_map_first = T_map_sensor.linear();
  const Eigen::Matrix2d with_sine = (R_map_first * K).topLeftCorner<2, 2>();
  const Eigen::Matrix2d with_cosine = (R_map_first * K * K).topLeftCorner<2, 2>();
  const Eigen::Rotation2Dd step(turned.angle() / last);
  const Eigen::Matrix2d step_matrix = step.toRotationMatrix();
  Eigen::Vector2d at(1.0, 0.0);
  map_x_.resize(n);
  map_y_.resize(n);
  origin_.x.resize(n);
  origin_.y.resize(n);
  R_swept_.resize(n);
  for (std::size_t i = 0; i < n; ++i, at = step_matrix * at) {
    R_swept_[i] = R_ + at.y() * with_sine + (1.0 - at.x()) * with_cosine;
    const Eigen::Vector2d p = R_swept_[i] * Eigen::Vector2d(direction_x_[i], direction_y_[i]);
    map_x_[i] = p.x();
    map_y_[i] = p.y();
    const Eigen::Vector2d o = static_cast<double>(i) / last * moved;
    const FinePoint origin = grid_.point(o.x(), o.y());
    origin_.x[i] = origin.x;
    origin_.y[i] = origin.y;
    bounds_.add(origin);
  }
  centre_ = grid_.point(0.5 * moved.x(), 0.5 * moved.y());
  bounds_.add(centre_);
}

void ScanBeams::put(const std::vector<double>& range, FinePoints& points) {
  const std::size_t n = range.size();
  points.x.resize(n + 1);
  points.y.resize(n + 1);
  with_widest_rows([&](auto) {
    round(grid_, n, range.data(), map_x_.data(), points.x.data());
    round(grid_, n, range.data(), map_y_.data(), points.y.data());
  });
  if (is_swept_) {
    for (std::size_t i = 0; i < n; ++i) {
      points.x[i] += origin_.x[i];
      points.y[i] += origin_.y[i];
    }
  }
  points.x[n] = points.x[0];
  points.y[n] = points.y[0];
  with_widest_rows([&](auto) { bounds_ = united(bounds_, points.x.data(), points.y.data(), n); });
}

void ScanBeams::count_turn(const RangeScan& scan) {
  const std::size_t n = size();
  const double step = std::abs(scan.angle_increment);
  may_join_ = step <= kWidest;
  is_round_ = goes_round_once(scan);
  const double turned = is_swept_ ? rotation_angle(scan.T_first_last) : 0.0;
  const double fitting = std::max(0.0, (2.0 * M_PI - kGap - turned) / step - 1.0);
  const bool closes = is_round_ && !is_swept_;
  const bool all_fit = closes || fitting >= static_cast<double>(n);
  first_turn_ = all_fit ? n : static_cast<std::size_t>(fitting);
}

FinePoint ScanBeams::origin(std::size_t i) const { return is_swept_ ? origin_.at(i) : FinePoint{}; }

FinePoint ScanBeams::beside(std::size_t i, double side) const {
  const double sine = side * half_sine_;
  const Eigen::Vector2d direction(direction_x_[i] * half_cosine_ - direction_y_[i] * sine,
                                  direction_y_[i] * half_cosine_ + direction_x_[i] * sine);
  const Eigen::Vector2d p = range_[i] * ((is_swept_ ? R_swept_[i] : R_) * direction);
  return origin(i) + grid_.point(p.x(), p.y());
}

}  // namespace portolan
