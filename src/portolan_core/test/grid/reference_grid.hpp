// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "portolan/grid/grid_mapper.hpp"

namespace portolan {

/// The slow grid map: every cell within reach is asked, by the definitions in draw.hpp and Eq. 7.
class ReferenceGrid {
 public:
  explicit ReferenceGrid(const GridOptions& options) : options_(options) {}

  void insert(const GridMapper::Observation& z, const Pose& T_map_sensor) {
    fine_ = 1024.0 / options_.resolution;
    T_ = T_map_sensor;
    anchor_x_ = std::llround(T_.translation().x() * fine_);
    anchor_y_ = std::llround(T_.translation().y() * fine_);
    regions_.clear();
    if (const auto* scan = std::get_if<RangeScan>(&z)) see(*scan);
    if (const auto* echo = std::get_if<RangeEcho>(&z)) see(*echo);
    if (const auto* cloud = std::get_if<PointCloud>(&z)) see(*cloud);
    update(static_cast<GridLayer>(z.index()));
  }

  /// P(occupied); none where nobody observed the cell.
  std::optional<double> probability(GridLayer layer, Cell cell) const {
    const auto found = cells_.find({static_cast<int>(layer), {cell.x, cell.y}});
    if (found == cells_.end()) return std::nullopt;
    return 1.0 - 1.0 / (1.0 + std::exp(options_.quantum * found->second));  // Eq. 8
  }

  std::size_t size() const { return cells_.size(); }

 private:
  struct Point {
    std::int64_t x, y;  // in 1/1024 of a cell, from the anchor
  };
  enum class Shape { polygon, ray, cone, cell };
  struct Region {
    Shape shape;
    bool occupied;
    std::vector<Point> points;
    std::int64_t inner = 0, outer = 0;  // of a cone
    double direction = 0.0, aperture = 0.0;
  };

  static double logit(double p) { return std::log(p / (1.0 - p)); }

  Point at(double x, double y) const { return {std::lround(x * fine_), std::lround(y * fine_)}; }

  // Even-odd, in integers: a centre on a left or lower edge is in, on a right or upper one out.
  static bool in_polygon(const std::vector<Point>& p, Point c) {
    bool in = false;
    for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
      if ((p[i].y <= c.y) == (p[j].y <= c.y)) continue;
      const std::int64_t dy = p[j].y - p[i].y;
      const std::int64_t side = (c.x - p[i].x) * dy - (c.y - p[i].y) * (p[j].x - p[i].x);
      if (dy > 0 ? side >= 0 : side <= 0) in = !in;
    }
    return in;
  }

  // `low` is the corner of the cell.
  static bool under_ray(const std::vector<Point>& ray, Point low) {
    Point a = ray[0];
    Point b = ray[1];
    if (std::abs(b.y - a.y) < std::abs(b.x - a.x)) {
      a = {a.y, a.x};
      b = {b.y, b.x};
      low = {low.y, low.x};
    }
    if (a.y > b.y) std::swap(a, b);
    const std::int64_t y = low.y + 512;
    if (y < a.y || y >= b.y) return false;
    const std::int64_t dy = b.y - a.y;
    const std::int64_t x = a.x * dy + (y - a.y) * (b.x - a.x);
    return low.x * dy <= x && x < (low.x + 1024) * dy;
  }

  static bool in_cone(const Region& r, Point c) {
    const std::int64_t square = c.x * c.x + c.y * c.y;
    if (square >= r.outer * r.outer || square < r.inner * r.inner) return false;
    for (std::size_t i = 0; i + 1 < r.points.size(); ++i) {
      if (in_polygon({{0, 0}, r.points[i], r.points[i + 1]}, c)) return true;
    }
    return false;
  }

  bool in_region(const Region& r, Point low) const {
    const Point centre{low.x + 512, low.y + 512};
    switch (r.shape) {
      case Shape::polygon:
        return in_polygon(r.points, centre);
      case Shape::ray:
        return under_ray(r.points, low);
      case Shape::cone:
        return in_cone(r, centre);
      case Shape::cell:
        break;
    }
    const Point p = r.points[0];
    return low.x <= p.x && p.x < low.x + 1024 && low.y <= p.y && p.y < low.y + 1024;
  }

  void update(GridLayer layer) {
    std::map<std::pair<int, int>, bool> seen;  // occupied wins over free
    for (const Region& region : regions_) {
      Point min = region.points[0];
      Point max = min;
      for (Point p : region.points) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
      }
      if (region.shape == Shape::cone) {
        min = {std::min<std::int64_t>(min.x, -region.outer), std::min(min.y, -region.outer)};
        max = {std::max<std::int64_t>(max.x, region.outer), std::max(max.y, region.outer)};
      }
      mark(region, min, max, seen);
    }
    for (const auto& [cell, occupied] : seen) change(layer, cell, occupied);
  }

  void mark(const Region& region, Point min, Point max,
            std::map<std::pair<int, int>, bool>& seen) const {
    for (auto y = ((min.y + anchor_y_) >> 10) - 1; y <= ((max.y + anchor_y_) >> 10) + 1; ++y) {
      for (auto x = ((min.x + anchor_x_) >> 10) - 1; x <= ((max.x + anchor_x_) >> 10) + 1; ++x) {
        if (!in_region(region, {x * 1024 - anchor_x_, y * 1024 - anchor_y_})) continue;
        seen[{static_cast<int>(x), static_cast<int>(y)}] |= region.occupied;
      }
    }
  }

  // Eq. 7 in whole quanta: l_t = l_{t-1} + tau - l_0, kept between p_min and p_max.
  void change(GridLayer layer, std::pair<int, int> cell, bool occupied) {
    const InverseSensorModel& model =
        layer == GridLayer::laser   ? static_cast<const InverseSensorModel&>(options_.laser)
        : layer == GridLayer::sonar ? static_cast<const InverseSensorModel&>(options_.sonar)
                                    : options_.cloud;
    const double q = options_.quantum;
    const int low = static_cast<int>(logit(options_.p_min) / q);
    const int high = static_cast<int>(logit(options_.p_max) / q);
    const int l_0 = std::clamp(static_cast<int>(std::lround(logit(options_.prior) / q)), low, high);
    const double tau = logit(occupied ? model.p_occupied : model.p_free);
    int step = static_cast<int>(std::lround(tau / q - l_0));
    if (step == 0) step = occupied ? 1 : -1;
    int& l = cells_.try_emplace({static_cast<int>(layer), cell}, l_0).first->second;
    l = std::clamp(l + step, low, high);
  }

  // ----- what the sensors say

  struct Beam {
    Point origin;
    Eigen::Matrix2d R;
    double angle;
    double free = 0.0;
    double hit = 0.0;
  };

  Point end(const Beam& beam, double angle, double range) const {
    const Eigen::Vector2d p = beam.R * Eigen::Vector2d(std::cos(angle), std::sin(angle)) * range;
    const Point fine = at(p.x(), p.y());
    return {beam.origin.x + fine.x, beam.origin.y + fine.y};
  }

  Beam beam(const RangeScan& scan, std::size_t i) const {
    const double n = static_cast<double>(scan.ranges.size());
    const bool moves = !scan.T_first_last.matrix().isIdentity(0.0);
    const double part = n > 1 ? static_cast<double>(i) / (n - 1) : 0.0;
    const Pose T = moves ? interpolate(T_, T_ * scan.T_first_last, part) : T_;
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

  void see(const RangeScan& scan) {
    std::vector<Beam> beams;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) beams.push_back(beam(scan, i));
    const double step = scan.angle_increment;
    const double half = std::copysign(std::min(std::abs(step), M_PI / 2.0) / 2.0, step);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      if (options_.laser.beam_model == BeamModel::sector) {
        see_side(beams, i, i + 1, step, half);
        see_side(beams, i, i == 0 ? beams.size() : i - 1, step, -half);
      } else if (beams[i].free > 0.0) {
        regions_.push_back(
            {Shape::ray, false, {beams[i].origin, end(beams[i], beams[i].angle, beams[i].free)}});
      }
      see_echo(beams[i], half);
    }
  }

  // The free region on one side of a beam: up to the neighbour, or half a step wide.
  void see_side(const std::vector<Beam>& beams, std::size_t i, std::size_t neighbour, double step,
                double half) {
    const std::size_t n = beams.size();
    const bool round =
        std::abs(static_cast<double>(n) * std::abs(step) - 2.0 * M_PI) < 1e-3 * std::abs(step);
    if (neighbour == n && round && n > 2) neighbour = half * step > 0.0 ? 0 : n - 1;
    const Beam& a = beams[i];
    if (a.free <= 0.0) return;
    const Point p = end(a, a.angle, a.free);
    if (neighbour < n && std::abs(step) <= M_PI / 2.0 && beams[neighbour].free > 0.0) {
      const Beam& b = beams[neighbour];
      const Point q = end(b, b.angle, b.free);
      regions_.push_back({Shape::polygon, false, {a.origin, p, q, b.origin}});
    } else {
      regions_.push_back({Shape::polygon, false, {a.origin, p, end(a, a.angle + half, a.free)}});
    }
  }

  void see_echo(const Beam& beam, double half) {
    if (beam.hit <= 0.0) return;
    regions_.push_back({Shape::cell, true, {end(beam, beam.angle, beam.hit)}});
    const double d = options_.laser.margin;
    if (d == 0.0) return;
    const double near = std::max(0.0, beam.hit - d);
    regions_.push_back(
        {Shape::polygon,
         true,
         {end(beam, beam.angle - half, near), end(beam, beam.angle - half, beam.hit + d),
          end(beam, beam.angle + half, beam.hit + d), end(beam, beam.angle + half, near)}});
  }

  void see(const RangeEcho& echo) {
    const SonarModel& sonar = options_.sonar;
    const double reach = std::min(sonar.max_range, echo.range_max);
    const double d = std::max(sonar.margin, options_.resolution / 2.0);
    const RangeReading reading = range_reading(echo.range, echo.range_min, echo.range_max);
    double near = 0.0;
    double far = 0.0;
    if (reading == RangeReading::hit && echo.range <= sonar.max_range) {
      near = std::max(0.0, echo.range - d);
      far = echo.range + d;
    } else if (reading == RangeReading::hit ||
               (reading == RangeReading::nothing_returned && sonar.no_return == NoReturn::clear)) {
      near = reach;
    }
    const Eigen::Vector2d axis = T_.linear().col(0).head<2>();
    const std::int64_t inner = std::llround(near * axis.norm() * fine_);
    const std::int64_t outer = std::llround(far * axis.norm() * fine_);
    Region cone{Shape::cone, false, {}};
    const int wedges = std::max(1, static_cast<int>(std::ceil(echo.aperture / (M_PI / 2.0))));
    const double rim =
        1.5 * (static_cast<double>(std::max(inner, outer)) / fine_ + options_.resolution);
    for (int i = 0; i <= wedges; ++i) {
      const double angle =
          std::atan2(axis.y(), axis.x()) + echo.aperture * (static_cast<double>(i) / wedges - 0.5);
      cone.points.push_back(at(rim * std::cos(angle), rim * std::sin(angle)));
    }
    cone.outer = inner;
    regions_.push_back(cone);
    cone.occupied = true;
    cone.inner = inner;
    cone.outer = outer;
    regions_.push_back(cone);
  }

  void see(const PointCloud& cloud) {
    for (const Eigen::Vector3f& p : cloud.points) {
      if (p.allFinite()) see_ray(T_.linear() * p.cast<double>(), true);
    }
    if (options_.cloud.no_return == NoReturn::ignore) return;
    for (const Eigen::Vector3f& d : cloud.no_returns) {
      if (d.allFinite())
        see_ray(T_.linear() * d.cast<double>().normalized() * options_.cloud.max_range, false);
    }
  }

  void see_ray(Eigen::Vector3d ray, bool returned) {
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

  GridOptions options_;
  double fine_ = 0.0;
  Pose T_ = Pose::Identity();
  std::int64_t anchor_x_ = 0, anchor_y_ = 0;
  std::vector<Region> regions_;
  std::map<std::pair<int, std::pair<int, int>>, int> cells_;  // by layer and cell: quanta
};

}  // namespace portolan
