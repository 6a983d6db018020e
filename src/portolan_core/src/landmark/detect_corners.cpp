// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <cmath>

#include "landmark/scan_points.hpp"

namespace portolan {

namespace {

/// A straight piece of wall.
struct Segment {
  Eigen::Vector2d center;
  Eigen::Vector2d along;  // unit vector, in the order of beams
  double length;
  double spread;  // sum of squared distances from the centre along it [m^2]
  std::size_t size;

  Eigen::Vector2d normal() const { return {-along.y(), along.x()}; }
};

using Points = std::vector<ScanPoint>;

Segment fit_segment(const Points& points, std::size_t first, std::size_t last) {
  Segment segment{};
  segment.size = last - first + 1;
  segment.center.setZero();
  for (std::size_t i = first; i <= last; ++i)
    segment.center += points[i].p / static_cast<double>(segment.size);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i <= last; ++i) {
    const Eigen::Vector2d step = points[i].p - segment.center;
    scatter += step * step.transpose();
  }
  const double angle = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  segment.along = {std::cos(angle), std::sin(angle)};
  const Eigen::Vector2d step = points[last].p - points[first].p;
  if (segment.along.dot(step) < 0.0) segment.along *= -1.0;
  segment.length = segment.along.dot(step);
  segment.spread = segment.along.dot(scatter * segment.along);
  return segment;
}

/// Splits a run of points where they are furthest from the line between its ends, until each part
/// is straight; appends the parts that are long enough.
void split(const Points& points, std::size_t first, std::size_t last, double tolerance,
           const CornerOptions& options, std::vector<Segment>& segments) {
  if (last - first + 1 < options.min_echoes) return;
  const Eigen::Vector2d chord = (points[last].p - points[first].p).normalized();
  std::size_t furthest = first;
  double most = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const Eigen::Vector2d step = points[i].p - points[first].p;
    const double distance = std::abs(chord.x() * step.y() - chord.y() * step.x());
    if (distance <= most) continue;
    most = distance;
    furthest = i;
  }
  if (most > tolerance && furthest > first && furthest < last) {
    split(points, first, furthest, tolerance, options, segments);
    split(points, furthest, last, tolerance, options, segments);
    return;
  }
  const Segment segment = fit_segment(points, first, last);
  if (segment.length >= options.min_length) segments.push_back(segment);
}

/// The variance of how far the wall's line is off at `p`.
double variance_at(const Eigen::Vector2d& p, const Segment& segment, double stddev) {
  const double distance = segment.along.dot(p - segment.center);
  return stddev * stddev *
         (1.0 / static_cast<double>(segment.size) + distance * distance / segment.spread);
}

void add_corner(const Segment& a, const Segment& b, const ScanDetectorOptions& detector,
                const CornerOptions& options, LandmarkSightings& found) {
  const double turn = std::abs(a.along.x() * b.along.y() - a.along.y() * b.along.x());
  if (turn < std::sin(options.min_angle)) return;
  const Eigen::Matrix2d N =
      (Eigen::Matrix2d() << a.normal().transpose(), b.normal().transpose()).finished();
  const Eigen::Matrix2d inverse = N.inverse();
  const Eigen::Vector2d p =
      inverse * Eigen::Vector2d(a.normal().dot(a.center), b.normal().dot(b.center));
  const Eigen::Vector2d end = a.center + 0.5 * a.length * a.along;
  const Eigen::Vector2d begin = b.center - 0.5 * b.length * b.along;
  if ((p - end).norm() > detector.gap || (p - begin).norm() > detector.gap) return;
  const Eigen::Vector2d variance(variance_at(p, a, detector.range_stddev),
                                 variance_at(p, b, detector.range_stddev));
  found.sightings.push_back(
      planar_sighting(p, inverse * variance.asDiagonal() * inverse.transpose()));
}

}  // namespace

LandmarkSightings detect_corners(const RangeScan& scan, const ScanDetectorOptions& detector,
                                 const CornerOptions& options) {
  constexpr double kTolerance = 3.0;  // deviations of an echo
  LandmarkSightings found;
  for (const Points& points : clustered(scan_points(scan, detector.max_range), detector.gap)) {
    std::vector<Segment> segments;
    split(points, 0, points.size() - 1, kTolerance * detector.range_stddev, options, segments);
    for (std::size_t i = 1; i < segments.size(); ++i)
      add_corner(segments[i - 1], segments[i], detector, options, found);
  }
  return found;
}

}  // namespace portolan
