// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "portolan/grid/draw.hpp"
#include "portolan/grid/fine_grid.hpp"
#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

// The radii in which cells are free, and from there on occupied [m].
struct Rings {
  double free = 0.0;
  double occupied = 0.0;
};

Rings rings(const RangeEcho& echo, const GridOptions& options) {
  const SonarModel& model = options.sonar;
  const double reach = std::min(model.max_range, echo.range_max);
  const double d = std::max(model.margin, options.resolution / 2.0);
  switch (range_reading(echo.range, echo.range_min, echo.range_max)) {
    case RangeReading::no_information:
      return {};
    case RangeReading::nothing_returned:
      return model.no_return == NoReturn::clear ? Rings{reach, 0.0} : Rings{};
    case RangeReading::hit:
      break;
  }
  if (echo.range > model.max_range) return {reach, 0.0};
  return {std::max(0.0, echo.range - d), echo.range + d};
}

// Where a cone points, seen from above: unit vectors.
struct Directions {
  Eigen::Vector2d axis;
  Eigen::Vector2d right;
  Eigen::Vector2d left;
  double half_cosine = 1.0;  // of half the aperture, which is at most half a turn
};

Directions directions(const Eigen::Vector2d& axis, double aperture) {
  const double cosine = std::cos(aperture / 2.0);
  const Eigen::Vector2d along = cosine * axis;
  const Eigen::Vector2d across = std::sin(aperture / 2.0) * Eigen::Vector2d(-axis.y(), axis.x());
  return {axis, along - across, along + across, aperture < 2.0 * M_PI ? cosine : -1.0};
}

// Corners of wedges of at most a quarter turn each, far enough outside a disc of this radius.
struct Fan {
  int wedges = 0;
  std::array<FinePoint, 5> corners;
};

Fan make_fan(const Directions& cone, double aperture, double radius, const FineGrid& grid) {
  const auto corner = [&](const Eigen::Vector2d& direction) {
    return grid.point(1.5 * radius * direction.x(), 1.5 * radius * direction.y());
  };
  Fan fan;
  fan.wedges = aperture <= M_PI / 2.0 ? 1 : static_cast<int>(std::ceil(aperture / (M_PI / 2.0)));
  fan.corners[0] = corner(cone.right);
  for (int i = 1; i < fan.wedges; ++i) {
    const double angle = aperture * (static_cast<double>(i) / fan.wedges - 0.5);
    fan.corners[static_cast<std::size_t>(i)] = corner(Eigen::Rotation2Dd(angle) * cone.axis);
  }
  const bool closed = aperture >= 2.0 * M_PI;
  fan.corners[static_cast<std::size_t>(fan.wedges)] = closed ? fan.corners[0] : corner(cone.left);
  return fan;
}

// The rectangle around the cone's part within `radius` [m].
FineBounds bounds(const Directions& cone, double radius, const FineGrid& grid) {
  FineBounds bounds;
  const auto add = [&](const Eigen::Vector2d& direction) {
    bounds.add(grid.point(radius * direction.x(), radius * direction.y()));
  };
  add(cone.left);
  add(cone.right);
  for (const Eigen::Vector2d& side : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1),
                                      Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, -1)}) {
    if (side.dot(cone.axis) >= cone.half_cosine) add(side);
  }
  return bounds;
}

}  // namespace

Outcome draw(const RangeEcho& echo, const Pose& T_map_sensor, const GridOptions& options,
             Footprint& footprint) {
  if (!is_usable(echo)) return Outcome::unusable;
  const Eigen::Vector2d axis = T_map_sensor.linear().col(0).head<2>();
  const double projected = axis.norm();
  if (projected < std::cos(options.max_tilt)) return Outcome::rejected;
  const FineGrid grid(options.resolution);
  const Rings seen = rings(echo, options);
  const std::int64_t free = grid.length(seen.free * projected);
  const std::int64_t occupied = grid.length(seen.occupied * projected);
  const double radius = static_cast<double>(std::max(free, occupied)) / grid.scale();
  const Directions cone = directions(axis / projected, echo.aperture);
  const Fan fan = make_fan(cone, echo.aperture, radius + options.resolution, grid);
  const FineBounds around = bounds(cone, radius, grid);
  if (!footprint.open(grid.anchor(T_map_sensor.translation()), around.min, around.max)) {
    return Outcome::unusable;
  }
  for (int i = 0; i < fan.wedges; ++i) {
    const auto k = static_cast<std::size_t>(i);
    footprint.cone(fan.corners[k], fan.corners[k + 1], free, occupied);
  }
  return Outcome::inserted;
}

}  // namespace portolan
