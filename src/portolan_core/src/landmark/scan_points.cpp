// SPDX-License-Identifier: BSD-3-Clause
#include "landmark/scan_points.hpp"

#include <cmath>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

std::vector<ScanPoint> scan_points(const RangeScan& scan, double max_range) {
  std::vector<ScanPoint> points;
  const double last = static_cast<double>(scan.ranges.size()) - 1.0;
  const bool moved = scan.T_first_last.matrix() != Pose::Identity().matrix();
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const auto range = static_cast<double>(scan.ranges[beam]);
    if (range_reading(range, scan.range_min, scan.range_max) != RangeReading::hit) continue;
    if (range > max_range) continue;
    const double angle = scan.angle_min + scan.angle_increment * static_cast<double>(beam);
    Eigen::Vector3d p(range * std::cos(angle), range * std::sin(angle), 0.0);
    if (moved && last > 0.0)
      p = interpolate(Pose::Identity(), scan.T_first_last, static_cast<double>(beam) / last) * p;
    points.push_back({beam, range, p.head<2>()});
  }
  return points;
}

std::vector<std::vector<ScanPoint>> clustered(const std::vector<ScanPoint>& points, double gap) {
  std::vector<std::vector<ScanPoint>> clusters;
  for (const ScanPoint& point : points) {
    const bool goes_on = !clusters.empty() && point.beam - clusters.back().back().beam <= 2 &&
                         (point.p - clusters.back().back().p).norm() <= gap;
    if (!goes_on) clusters.emplace_back();
    clusters.back().push_back(point);
  }
  return clusters;
}

LandmarkSighting planar_sighting(const Eigen::Vector2d& p, const Eigen::Matrix2d& covariance) {
  const double range = p.norm();
  const Eigen::Vector2d along = p / range;
  const Eigen::Vector2d across(-along.y(), along.x());
  LandmarkSighting sighting;
  sighting.range = range;
  sighting.azimuth = std::atan2(p.y(), p.x());
  sighting.range_stddev = std::sqrt(along.dot(covariance * along));
  sighting.azimuth_stddev = std::sqrt(across.dot(covariance * across)) / range;
  return sighting;
}

}  // namespace portolan
