// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/missing_directions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace portolan {

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double kTolerance = 0.5;   // of the step from one place to the next
constexpr std::size_t kFewest = 20;  // points that returned

/// The straight line through pairs (x, y), by least squares.
class LineFit {
 public:
  struct Line {
    double slope;
    double offset;
    double operator()(double x) const { return slope * x + offset; }
  };

  void add(double x, double y) {
    ++n_;
    const double dx = x - mean_x_;
    const double dy = y - mean_y_;
    mean_x_ += dx / n_;
    mean_y_ += dy / n_;
    xx_ += dx * (x - mean_x_);
    xy_ += dx * (y - mean_y_);
    yy_ += dy * (y - mean_y_);
  }

  /// None where the pairs do not lie on one, to within a part of its slope.
  std::optional<Line> line() const {
    if (!(xx_ > 0.0)) return std::nullopt;
    const double slope = xy_ / xx_;
    const double rms = std::sqrt(std::max(0.0, yy_ - slope * xy_) / n_);
    if (!(std::abs(slope) > 0.0 && rms <= kTolerance * std::abs(slope))) return std::nullopt;
    return Line{slope, mean_y_ - slope * mean_x_};
  }

 private:
  double n_ = 0.0;
  double mean_x_ = 0.0;
  double mean_y_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
  double yy_ = 0.0;
};

/// Files the direction of a place under what it holds instead of a point.
void add(const Eigen::Vector3f& place, const Eigen::Vector3f& direction, MissingDirections& all) {
  int axis = -1;  // of those along which it lies at infinity, the one that tells the side best
  for (int i = 0; i < 3; ++i) {
    if (std::isinf(place[i]) && (axis < 0 || std::abs(direction[i]) > std::abs(direction[axis]))) {
      axis = i;
    }
  }
  if (axis < 0) {
    all.unknown.push_back(direction);
  } else if (place[axis] * direction[axis] > 0.0F) {
    all.nothing_returned.push_back(direction);
  }
}

/// The missing places' directions for a camera that looks along an axis (0: x, 2: z).
std::optional<MissingDirections> seen_by_camera(const Points& points, std::size_t width,
                                                int forward) {
  const int across = (forward + 1) % 3;
  const int down = (forward + 2) % 3;
  LineFit columns;
  LineFit rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points[i].cast<double>();
    if (!p.allFinite()) continue;
    if (!(p[forward] > 0.0)) return std::nullopt;
    const std::size_t row = i / width;
    columns.add(static_cast<double>(i % width), p[across] / p[forward]);
    rows.add(static_cast<double>(row), p[down] / p[forward]);
  }
  const auto x = columns.line();
  const auto y = rows.line();
  if (!x || !y) return std::nullopt;
  MissingDirections directions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) continue;
    const std::size_t row = i / width;
    Eigen::Vector3d ray;
    ray[forward] = 1.0;
    ray[across] = (*x)(static_cast<double>(i % width));
    ray[down] = (*y)(static_cast<double>(row));
    add(points[i], ray.normalized().cast<float>(), directions);
  }
  return directions;
}

double azimuth(const Eigen::Vector3f& p) {
  return std::atan2(static_cast<double>(p.y()), static_cast<double>(p.x()));
}

/// The usual turn from one place of a row to the next [rad]; none where no two neighbours returned.
std::optional<double> turn_per_place(const Points& points, std::size_t width) {
  std::vector<double> turns;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i % width == 0 || !points[i].allFinite() || !points[i - 1].allFinite()) continue;
    turns.push_back(std::remainder(azimuth(points[i]) - azimuth(points[i - 1]), 2.0 * M_PI));
  }
  if (turns.empty()) return std::nullopt;
  const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2);
  std::nth_element(turns.begin(), middle, turns.end());
  return *middle;
}

/// One ring of a turning laser.
struct Ring {
  double first;      // azimuth of its first place [rad]
  double elevation;  // [rad]
};

/// None where the points of the row do not lie on a ring with this turn.
std::optional<Ring> ring(const Points& points, std::size_t begin, std::size_t width, double turn) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double elevations = 0.0;
  double squares = 0.0;
  double n = 0.0;
  for (std::size_t i = 0; i < width; ++i) {
    const Eigen::Vector3f& p = points[begin + i];
    if (!p.allFinite()) continue;
    const double first = azimuth(p) - turn * static_cast<double>(i);
    sum += Eigen::Vector2d(std::cos(first), std::sin(first));
    const double elevation =
        std::atan2(static_cast<double>(p.z()), p.head<2>().cast<double>().norm());
    elevations += elevation;
    squares += elevation * elevation;
    n += 1.0;
  }
  if (n < 2.0) return std::nullopt;
  const double mean = elevations / n;
  const double largest = kTolerance * std::abs(turn);
  const bool agrees =
      sum.norm() / n >= std::cos(largest) && squares / n - mean * mean <= largest * largest;
  if (!agrees) return std::nullopt;
  return Ring{std::atan2(sum.y(), sum.x()), mean};
}

MissingDirections seen_by_laser(const Points& points, std::size_t width) {
  MissingDirections directions;
  const std::optional<double> turn = turn_per_place(points, width);
  if (!turn || *turn == 0.0) return directions;
  for (std::size_t begin = 0; begin + width <= points.size(); begin += width) {
    const std::optional<Ring> on = ring(points, begin, width, *turn);
    if (!on) continue;
    for (std::size_t i = 0; i < width; ++i) {
      if (points[begin + i].allFinite()) continue;
      const double a = on->first + *turn * static_cast<double>(i);
      const double e = on->elevation;
      const Eigen::Vector3d ray(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
      add(points[begin + i], ray.cast<float>(), directions);
    }
  }
  return directions;
}

}  // namespace

MissingDirections missing_directions(const std::vector<Eigen::Vector3f>& points,
                                     std::size_t width) {
  const auto returned = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Eigen::Vector3f& p) { return p.allFinite(); }));
  if (width < 2 || points.size() < 2 * width || returned < kFewest || returned == points.size()) {
    return {};
  }
  for (const int forward : {2, 0}) {
    if (auto directions = seen_by_camera(points, width, forward)) return *std::move(directions);
  }
  return seen_by_laser(points, width);
}

}  // namespace portolan
