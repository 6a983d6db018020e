// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "landmark/scan_points.hpp"

namespace portolan {

namespace {

struct Circle {
  Eigen::Vector3d x;  // centre and radius [m]
  Eigen::Matrix3d covariance;
  double misfit;  // root mean square of distances [m]
};

/// Least squares of distances from the circle (Gauss-Newton). Few echoes see little of its
/// curvature: what is known of radii beforehand counts as one more measurement.
Circle fit_circle(const std::vector<ScanPoint>& points, double stddev, const PoleOptions& options) {
  const double usual_radius = 0.5 * (options.min_radius + options.max_radius);
  const double radius_stddev = 0.25 * (options.max_radius - options.min_radius);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const ScanPoint& point : points) mean += point.p / static_cast<double>(points.size());
  Circle circle;
  circle.x << mean + usual_radius * mean.normalized(), usual_radius;
  for (int iteration = 0; iteration < 10; ++iteration) {
    const double weight = 1.0 / (radius_stddev * radius_stddev);
    Eigen::Matrix3d information = Eigen::Vector3d(0.0, 0.0, weight).asDiagonal();
    Eigen::Vector3d vector(0.0, 0.0, weight * (usual_radius - circle.x[2]));
    double squares = 0.0;
    for (const ScanPoint& point : points) {
      const Eigen::Vector2d step = circle.x.head<2>() - point.p;
      const double error = step.norm() - circle.x[2];
      const Eigen::Vector3d J(step.x() / step.norm(), step.y() / step.norm(), -1.0);
      information += J * J.transpose() / (stddev * stddev);
      vector -= J * error / (stddev * stddev);
      squares += error * error;
    }
    circle.x += information.ldlt().solve(vector);
    circle.covariance = information.inverse();
    circle.misfit = std::sqrt(squares / static_cast<double>(points.size()));
  }
  return circle;
}

/// True where the cluster's ends are its own: what lies beside it is further away.
bool stands_alone(const std::vector<std::vector<ScanPoint>>& clusters, std::size_t i, double gap) {
  const ScanPoint& first = clusters[i].front();
  const ScanPoint& last = clusters[i].back();
  const bool hidden_before = i > 0 && clusters[i - 1].back().beam + 2 >= first.beam &&
                             clusters[i - 1].back().range < first.range + gap;
  const bool hidden_behind = i + 1 < clusters.size() &&
                             clusters[i + 1].front().beam <= last.beam + 2 &&
                             clusters[i + 1].front().range < last.range + gap;
  return !hidden_before && !hidden_behind;
}

}  // namespace

LandmarkSightings detect_poles(const RangeScan& scan, const ScanDetectorOptions& detector,
                               const PoleOptions& options) {
  constexpr double kMostMisfit = 2.0;  // deviations of an echo
  LandmarkSightings found;
  const auto clusters = clustered(scan_points(scan, detector.max_range), detector.gap);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::vector<ScanPoint>& cluster = clusters[i];
    const double width = (cluster.back().p - cluster.front().p).norm();
    if (cluster.size() < options.min_echoes || width > 2.0 * options.max_radius) continue;
    if (!stands_alone(clusters, i, 0.5 * detector.gap)) continue;
    const Circle circle = fit_circle(cluster, detector.range_stddev, options);
    const bool is_round = circle.misfit < kMostMisfit * detector.range_stddev &&
                          circle.x[2] > options.min_radius && circle.x[2] < options.max_radius;
    if (!is_round || circle.x.head<2>().norm() <= circle.x[2]) continue;
    found.sightings.push_back(
        planar_sighting(circle.x.head<2>(), circle.covariance.topLeftCorner<2, 2>()));
  }
  return found;
}

}  // namespace portolan
