// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "landmark/scan_points.hpp"

namespace portolan {

namespace {

double width(const std::vector<ScanPoint>& cluster) {
  double most = 0.0;
  for (const ScanPoint& point : cluster)
    most = std::max(most, (point.p - cluster.front().p).norm());
  return most;
}

}  // namespace

LandmarkSightings detect_reflectors(const RangeScan& scan, const std::vector<float>& intensities,
                                    const ScanDetectorOptions& detector,
                                    const ReflectorOptions& options) {
  LandmarkSightings found;
  if (intensities.size() != scan.ranges.size()) return found;
  std::vector<ScanPoint> bright = scan_points(scan, detector.max_range);
  const auto is_dull = [&](const ScanPoint& point) {
    return !(static_cast<double>(intensities[point.beam]) >= options.min_intensity);
  };
  bright.erase(std::remove_if(bright.begin(), bright.end(), is_dull), bright.end());
  for (const std::vector<ScanPoint>& cluster : clustered(bright, detector.gap)) {
    if (width(cluster) > options.max_width) continue;
    const auto size = static_cast<double>(cluster.size());
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    for (const ScanPoint& point : cluster) p += point.p / size;
    p += options.radius * p.normalized();
    // Its edges lie anywhere between the beams that met it and those that did not.
    const double step = std::abs(scan.angle_increment) * p.norm();
    const double along = detector.range_stddev * detector.range_stddev / size;
    const double across = step * step / 6.0;
    const Eigen::Vector2d u = p.normalized();
    const Eigen::Matrix2d covariance =
        along * u * u.transpose() + across * (Eigen::Matrix2d::Identity() - u * u.transpose());
    found.sightings.push_back(planar_sighting(p, covariance));
  }
  return found;
}

}  // namespace portolan
