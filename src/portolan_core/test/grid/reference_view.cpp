// SPDX-License-Identifier: BSD-3-Clause
#include "grid/reference_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace portolan {
namespace {

bool moves(const RangeScan& scan) { return !scan.T_first_last.matrix().isIdentity(0.0); }

bool goes_round(const RangeScan& scan) {
  const double step = std::abs(scan.angle_increment);
  const double n = static_cast<double>(scan.ranges.size());
  return n > 2.0 && std::abs(n * step - 2.0 * M_PI) < 1e-3 * step;
}

// How many beams the sensor sends in its first turn.
std::size_t first_turn(const RangeScan& scan) {
  if (goes_round(scan) && !moves(scan)) return scan.ranges.size();
  const double turned = moves(scan) ? rotation_angle(scan.T_first_last) : 0.0;
  const double fitting = (2.0 * M_PI - 0.1 - turned) / std::abs(scan.angle_increment) - 1.0;
  return static_cast<std::size_t>(std::max(0.0, fitting));
}

}  // namespace

ReferenceView::ReferenceView(const GridOptions& options, const Pose& T_map_sensor,
                             const GridMapper::Observation& z)
    : options_(options),
      T_(T_map_sensor),
      fine_(1024.0 / options.resolution),
      anchor_{std::llround(T_.translation().x() * fine_),
              std::llround(T_.translation().y() * fine_)} {
  std::visit([this](const auto& seen) { see(seen); }, z);
}

ReferenceRegion::Point ReferenceView::at(double x, double y) const {
  return {std::llround(x * fine_), std::llround(y * fine_)};
}

ReferenceRegion::Point ReferenceView::end(const Beam& beam, double angle, double range) const {
  const Eigen::Vector2d p = beam.R * Eigen::Vector2d(std::cos(angle), std::sin(angle)) * range;
  const Point fine = at(p.x(), p.y());
  return {beam.origin.x + fine.x, beam.origin.y + fine.y};
}

ReferenceView::Beam ReferenceView::beam(const RangeScan& scan, std::size_t i) const {
  const double n = static_cast<double>(scan.ranges.size());
  const double part = n > 1 ? static_cast<double>(i) / (n - 1) : 0.0;
  const Pose T = moves(scan) ? interpolate(T_, T_ * scan.T_first_last, part) : T_;
  const Eigen::Vector3d moved = T.translation() - T_.translation();
  Beam beam{at(moved.x(), moved.y()), T.linear().topLeftCorner<2, 2>(),
            scan.angle_min + static_cast<double>(i) * scan.angle_increment};
  const LaserModel& laser = options_.laser;
  const double range = static_cast<double>(scan.ranges[i]);
  const RangeReading reading = range_reading(range, scan.range_min, scan.range_max);
  if (reading == RangeReading::hit && range <= laser.max_range) beam.hit = range;
  if (reading == RangeReading::hit) beam.free = std::min(range - laser.margin, laser.max_range);
  if (reading == RangeReading::nothing_returned && laser.no_return == NoReturn::clear) {
    beam.free = std::min(scan.range_max, laser.max_range);
  }
  if (beam.free < options_.resolution / 32.0) beam.free = 0.0;
  return beam;
}

void ReferenceView::see(const RangeScan& scan) {
  std::vector<Beam> beams;
  beams.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) beams.push_back(beam(scan, i));
  const double step = scan.angle_increment;
  const double half = std::copysign(std::min(std::abs(step), M_PI / 2.0) / 2.0, step);
  const Eigen::Vector3d moved = T_.linear() * scan.T_first_last.translation();
  centre_ = at(0.5 * moved.x(), 0.5 * moved.y());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (options_.laser.beam_model == BeamModel::sector) {
      see_side(scan, beams, i, i + 1, half);
      see_side(scan, beams, i, i == 0 ? beams.size() : i - 1, -half);
    } else if (beams[i].free > 0.0) {
      regions_.push_back(
          {Shape::ray, false, {beams[i].origin, end(beams[i], beams[i].angle, beams[i].free)}});
    }
    if (beams[i].hit <= 0.0) continue;
    regions_.push_back({Shape::cell, true, {end(beams[i], beams[i].angle, beams[i].hit)}});
  }
  for (const ReferenceRegion& region : {outline_, strips_}) {
    if (!region.points.empty()) regions_.push_back(region);
  }
}

void ReferenceView::add(ReferenceRegion& outline, const std::vector<Point>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    outline.points.push_back(polygon[i]);
    outline.points.push_back(polygon[(i + 1) % polygon.size()]);
  }
}

// The sector on one side of a beam: up to the neighbour, or half a step wide.
void ReferenceView::see_side(const RangeScan& scan, const std::vector<Beam>& beams, std::size_t i,
                             std::size_t neighbour, double half) {
  const double step = scan.angle_increment;
  const std::size_t n = beams.size();
  if (neighbour == n && goes_round(scan)) neighbour = half * step > 0.0 ? 0 : n - 1;
  const Beam& a = beams[i];
  if (a.free <= 0.0) return;
  if (neighbour < n && std::abs(step) <= M_PI / 2.0 && beams[neighbour].free > 0.0) {
    if (half * step > 0.0) see_between(scan, beams, i, neighbour);
    return;
  }
  const std::vector<Point> sector = {centre_, end(a, a.angle, a.free),
                                     end(a, a.angle + half, a.free)};
  if (i < first_turn(scan)) return add(outline_, sector);
  regions_.push_back({Shape::polygon, false, sector});
}

// The sector from a beam to the next one and, where they see one surface, the strip beyond it.
void ReferenceView::see_between(const RangeScan& scan, const std::vector<Beam>& beams,
                                std::size_t i, std::size_t next) {
  const Beam& a = beams[i];
  const Beam& b = beams[next];
  const double d = options_.laser.margin;
  const Point p = end(a, a.angle, a.free);
  const Point q = end(b, b.angle, b.free);
  const std::vector<Point> sector = {centre_, p, q};
  const std::vector<Point> strip = {p, end(a, a.angle, a.hit + d), end(b, b.angle, b.hit + d), q};
  const bool has_strip = d > 0.0 && a.hit > 0.0 && b.hit > 0.0 &&
                         std::abs(a.hit - b.hit) <= 2.0 * d + options_.resolution;
  if (i < first_turn(scan) && next < first_turn(scan) && !(next == 0 && moves(scan))) {
    add(outline_, sector);
    if (has_strip) add(strips_, strip);
  } else {
    regions_.push_back({Shape::polygon, false, sector});
    if (has_strip) regions_.push_back({Shape::polygon, true, strip});
  }
}

void ReferenceView::see(const RangeEcho& echo) {
  const SonarModel& sonar = options_.sonar;
  const double d = std::max(sonar.margin, options_.resolution / 2.0);
  const RangeReading reading = range_reading(echo.range, echo.range_min, echo.range_max);
  double near = 0.0;
  double far = 0.0;
  if (reading == RangeReading::hit && echo.range <= sonar.max_range) {
    near = std::max(0.0, echo.range - d);
    far = echo.range + d;
  } else if (reading == RangeReading::hit ||
             (reading == RangeReading::nothing_returned && sonar.no_return == NoReturn::clear)) {
    near = std::min(sonar.max_range, echo.range_max);
  }
  const double level = T_.linear().col(0).head<2>().norm();
  const std::int64_t inner = std::llround(near * level * fine_);
  const std::int64_t outer = std::llround(far * level * fine_);
  const double reach = static_cast<double>(std::max(inner, outer)) / fine_;
  const std::vector<Point> points = rim(echo, 1.5 * (reach + options_.resolution));
  regions_.push_back({Shape::cone, false, points, 0, inner});
  regions_.push_back({Shape::cone, true, points, inner, outer});
}

// Points around the cone's aperture, a quarter of a turn apart at most.
std::vector<ReferenceRegion::Point> ReferenceView::rim(const RangeEcho& echo, double radius) const {
  const Eigen::Vector2d axis = T_.linear().col(0).head<2>();
  const int wedges = std::max(1, static_cast<int>(std::ceil(echo.aperture / (M_PI / 2.0))));
  std::vector<Point> points;
  for (int i = 0; i <= wedges; ++i) {
    const double angle =
        std::atan2(axis.y(), axis.x()) + echo.aperture * (static_cast<double>(i) / wedges - 0.5);
    points.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return points;
}

void ReferenceView::see(const PointCloud& cloud) {
  for (const Eigen::Vector3f& p : cloud.points) {
    if (p.norm() < 1e6F) see_ray(T_.linear() * p.cast<double>(), true);
  }
  if (options_.cloud.no_return == NoReturn::ignore) return;
  for (const Eigen::Vector3f& d : cloud.no_returns) {
    if (!d.allFinite()) continue;
    see_ray(T_.linear() * d.cast<double>().normalized() * options_.cloud.max_range, false);
  }
}

void ReferenceView::see_ray(Eigen::Vector3d ray, bool returned) {
  const CloudModel& model = options_.cloud;
  if (returned && ray.norm() > model.max_range) {
    ray = ray.normalized() * model.max_range;
    returned = false;
  }
  const double z = T_.translation().z();
  double from = 0.0;
  double to = 1.0;
  for (const auto& [limit, sign] : {std::pair(model.min_z, 1.0), std::pair(model.max_z, -1.0)}) {
    const double inside = sign * (z - limit);  // how far the ray's start is inside this limit
    const double change = sign * ray.z();
    if (change == 0.0 && inside < 0.0) return;
    if (change > 0.0) from = std::max(from, -inside / change);
    if (change < 0.0) to = std::min(to, -inside / change);
  }
  if (from > to) return;
  const Point end = at(to * ray.x(), to * ray.y());
  regions_.push_back({Shape::ray, false, {at(from * ray.x(), from * ray.y()), end}});
  const double height = z + ray.z();
  if (returned && model.min_z <= height && height <= model.max_z) {
    regions_.push_back({Shape::cell, true, {end}});
  }
}

}  // namespace portolan
