// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace portolan::sim {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a ray that lies in something, and the normal where it enters.
struct Span {
  double enter = -kInfinity;
  double leave = kInfinity;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();

  bool empty() const { return enter > leave; }
};

/// Keeps what lies between two parallel planes: |position + t * speed| <= half, along `axis`.
void clip(Span& span, double position, double speed, double half, const Eigen::Vector3d& axis) {
  if (speed == 0.0) {
    if (std::abs(position) > half) span.leave = -kInfinity;
    return;
  }
  const double sign = speed > 0.0 ? 1.0 : -1.0;
  const double enter = (-sign * half - position) / speed;
  const double leave = (sign * half - position) / speed;
  if (enter > span.enter) {
    span.enter = enter;
    span.normal = -sign * axis;
  }
  span.leave = std::min(span.leave, leave);
}

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

void clip_rectangle(Span& span, const Obstacle& box, const Ray& ray) {
  const Eigen::Vector2d from_center = ray.origin.head<2>() - box.center;
  const Eigen::Vector2d along = box.axis;
  const Eigen::Vector2d across = perpendicular(box.axis);
  const Eigen::Vector2d direction = ray.direction.head<2>();
  clip(span, from_center.dot(along), direction.dot(along), box.half.x(),
       {along.x(), along.y(), 0.0});
  if (span.empty()) return;
  clip(span, from_center.dot(across), direction.dot(across), box.half.y(),
       {across.x(), across.y(), 0.0});
}

void clip_disc(Span& span, const Obstacle& disc, const Ray& ray) {
  const Eigen::Vector2d from_center = ray.origin.head<2>() - disc.center;
  const Eigen::Vector2d direction = ray.direction.head<2>();
  const double radius = disc.half.x();
  const double a = direction.squaredNorm();
  const double b = from_center.dot(direction);
  const double c = from_center.squaredNorm() - radius * radius;
  if (a == 0.0) {
    if (c > 0.0) span.leave = -kInfinity;
    return;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    span.leave = -kInfinity;
    return;
  }
  const double root = std::sqrt(discriminant);
  span.enter = (-b - root) / a;
  span.leave = (-b + root) / a;
  const Eigen::Vector2d normal = (from_center + span.enter * direction) / radius;
  span.normal << normal, 0.0;
}

}  // namespace

std::optional<Hit> intersect(const Obstacle& obstacle, const Ray& ray, double max_range) {
  Span span;
  if (obstacle.footprint == Obstacle::Footprint::disc) {
    clip_disc(span, obstacle, ray);
  } else {
    clip_rectangle(span, obstacle, ray);
  }
  if (span.empty() || span.leave < 0.0 || span.enter > max_range) return std::nullopt;
  const double middle = 0.5 * (obstacle.bottom + obstacle.top);
  clip(span, ray.origin.z() - middle, ray.direction.z(), 0.5 * (obstacle.top - obstacle.bottom),
       Eigen::Vector3d::UnitZ());
  if (span.empty() || span.leave < 0.0 || span.enter > max_range) return std::nullopt;
  if (span.enter < 0.0) return Hit{0.0, -ray.direction, obstacle.material};
  return Hit{span.enter, span.normal, obstacle.material};
}

double distance(const Obstacle& obstacle, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d from_center = p_map - obstacle.center;
  if (obstacle.footprint == Obstacle::Footprint::disc) {
    return std::max(0.0, from_center.norm() - obstacle.half.x());
  }
  const Eigen::Vector2d local(from_center.dot(obstacle.axis),
                              from_center.dot(perpendicular(obstacle.axis)));
  return (local.cwiseAbs() - obstacle.half).cwiseMax(0.0).norm();
}

bool overlaps(const Obstacle& obstacle, const Eigen::Vector2d& square_center, double half_side) {
  constexpr double kTouching = 1e-9;
  const Eigen::Vector2d offset = square_center - obstacle.center;
  if (obstacle.footprint == Obstacle::Footprint::disc) {
    const Eigen::Vector2d outside = (offset.cwiseAbs().array() - half_side).cwiseMax(0.0);
    return outside.norm() < obstacle.half.x() - kTouching;
  }
  // Two convex shapes are apart where the normal of one of their sides separates them.
  const Eigen::Vector2d extent = half_extent(obstacle);
  const double projected = half_side * (std::abs(obstacle.axis.x()) + std::abs(obstacle.axis.y()));
  return std::abs(offset.x()) < extent.x() + half_side - kTouching &&
         std::abs(offset.y()) < extent.y() + half_side - kTouching &&
         std::abs(offset.dot(obstacle.axis)) < obstacle.half.x() + projected - kTouching &&
         std::abs(offset.dot(perpendicular(obstacle.axis))) <
             obstacle.half.y() + projected - kTouching;
}

Eigen::Vector2d half_extent(const Obstacle& obstacle) {
  if (obstacle.footprint == Obstacle::Footprint::disc) return obstacle.half;
  return obstacle.axis.cwiseAbs() * obstacle.half.x() +
         perpendicular(obstacle.axis).cwiseAbs() * obstacle.half.y();
}

}  // namespace portolan::sim
