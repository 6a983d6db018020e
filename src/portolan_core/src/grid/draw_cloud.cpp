// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "portolan/grid/draw.hpp"
#include "portolan/grid/fine_grid.hpp"
#include "portolan/observation/limits.hpp"

namespace portolan {

namespace {

// A ray's part inside the height band, seen from above, from the anchor.
struct Trace {
  FinePoint from;
  FinePoint to;
  bool occupied = false;  // it ends in an obstacle within the band
};

class Slicer {
 public:
  Slicer(const Pose& T_map_sensor, const GridOptions& options)
      : grid_(options.resolution), model_(options.cloud), height_(T_map_sensor.translation().z()) {}

  // The trace of a ray along `ray` [m] in map axes, or nothing where it never enters the band.
  std::optional<Trace> trace(Eigen::Vector3d ray, bool returned) const {
    const double range = ray.norm();
    if (returned && range > model_.max_range) {
      ray *= model_.max_range / range;
      returned = false;
    }
    double enter = 0.0;
    double leave = 1.0;
    if (!clip(ray.z(), enter, leave)) return std::nullopt;
    const auto at = [&](double part) { return grid_.point(part * ray.x(), part * ray.y()); };
    const double end = height_ + ray.z();
    return Trace{at(enter), at(leave), returned && model_.min_z <= end && end <= model_.max_z};
  }

 private:
  // Narrows [enter, leave] to the part of the ray, which rises by `rise`, inside the band.
  bool clip(double rise, double& enter, double& leave) const {
    const double below = model_.min_z - height_;
    const double above = model_.max_z - height_;
    if (rise == 0.0) return below <= 0.0 && 0.0 <= above;
    enter = std::max(enter, std::min(below / rise, above / rise));
    leave = std::min(leave, std::max(below / rise, above / rise));
    return enter <= leave;
  }

  FineGrid grid_;
  CloudModel model_;
  double height_;
};

std::vector<Trace> traces(const PointCloud& cloud, const Pose& T_map_sensor,
                          const GridOptions& options) {
  const Slicer slicer(T_map_sensor, options);
  const Eigen::Matrix3d R = T_map_sensor.linear();
  std::vector<Trace> traces;
  traces.reserve(cloud.points.size() + cloud.no_returns.size());
  const auto add = [&](const Eigen::Vector3d& ray_sensor, bool returned) {
    const auto trace = slicer.trace(R * ray_sensor, returned);
    if (trace) traces.push_back(*trace);
  };
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d ray = p.cast<double>();
    if (ray.norm() < kFurthestReading) add(ray, true);  // false for NaN too
  }
  if (options.cloud.no_return == NoReturn::clear) {
    for (const Eigen::Vector3f& direction : cloud.no_returns) {
      const Eigen::Vector3d ray = options.cloud.max_range * direction.cast<double>().normalized();
      if (ray.allFinite()) add(ray, false);
    }
  }
  return traces;
}

}  // namespace

Outcome draw(const PointCloud& cloud, const Pose& T_map_sensor, const GridOptions& options,
             Footprint& footprint) {
  if (cloud.points.empty() && cloud.no_returns.empty()) return Outcome::unusable;
  const std::vector<Trace> seen = traces(cloud, T_map_sensor, options);
  FineBounds bounds;
  for (const Trace& trace : seen) {
    bounds.add(trace.from);
    bounds.add(trace.to);
  }
  const FineGrid grid(options.resolution);
  if (!footprint.open(grid.anchor(T_map_sensor.translation()), bounds.min, bounds.max)) {
    return Outcome::unusable;
  }
  for (const Trace& trace : seen) {
    footprint.ray(trace.from, trace.to);
    if (trace.occupied) footprint.occupy(trace.to);
  }
  return Outcome::inserted;
}

}  // namespace portolan
