// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/echo_cone.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;

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

// `direction`, which was seen along the x axis, as it is seen along `axis`.
Eigen::Vector2d turned(const Eigen::Vector2d& direction, const Eigen::Vector2d& axis) {
  return {direction.x() * axis.x() - direction.y() * axis.y(),
          direction.x() * axis.y() + direction.y() * axis.x()};
}

Cell tile_of(Cell cell) { return {cell.x >> TileMap::kSideLog2, cell.y >> TileMap::kSideLog2}; }

// From the lower end of a tile [cell].
double from_tile(std::int64_t fine, int tile) {
  constexpr std::int64_t kFineSide = std::int64_t{kSide} * Footprint::kFine;
  return static_cast<double>(fine - tile * kFineSide) / Footprint::kFine;
}

}  // namespace

bool EchoCone::place(const RangeEcho& echo, const Pose& T_map_sensor, const GridOptions& options) {
  look_up_aperture(echo.aperture);
  const FineGrid grid(options.resolution);
  const Eigen::Vector2d axis_in_plane = T_map_sensor.linear().col(0).head<2>();
  const double projected = axis_in_plane.norm();
  const Eigen::Vector2d axis = axis_in_plane / projected;
  const Rings seen = rings(echo, options);
  const std::int64_t free = grid.length(seen.free * projected);
  const std::int64_t reach = std::max(free, grid.length(seen.occupied * projected));
  const double radius = static_cast<double>(reach) / grid.scale();
  apex_ = grid.anchor(T_map_sensor.translation());
  rows_.set_radii(free, reach);
  place_wedges(axis, 1.5 * (radius + options.resolution), grid);
  return cover(axis, radius, grid);
}

void EchoCone::look_up_aperture(double aperture) {
  if (aperture_ == aperture) return;
  aperture_ = aperture;
  wedges_ = static_cast<std::size_t>(std::ceil(aperture / (M_PI / 2.0)));
  for (std::size_t i = 0; i <= wedges_; ++i) {
    const double angle = aperture * (static_cast<double>(i) / static_cast<double>(wedges_) - 0.5);
    directions_[i] = {std::cos(angle), std::sin(angle)};
  }
}

void EchoCone::place_wedges(const Eigen::Vector2d& axis, double radius, const FineGrid& grid) {
  const auto side = [&](std::size_t i) {
    const Eigen::Vector2d p = radius * turned(directions_[i], axis);
    return grid.point(p.x(), p.y());
  };
  const FinePoint first = side(0);
  FinePoint right = first;
  rows_.count = 0;
  for (std::size_t i = 1; i <= wedges_; ++i) {
    const bool closes = i == wedges_ && aperture_ >= 2.0 * M_PI;
    const FinePoint left = closes ? first : side(i);
    rows_.add(right, left);
    right = left;
  }
}

// Finds the rectangle around the cone's part within `radius` [m].
bool EchoCone::cover(const Eigen::Vector2d& axis, double radius, const FineGrid& grid) {
  FineBounds bounds;
  const auto add = [&](const Eigen::Vector2d& direction) {
    bounds.add(grid.point(radius * direction.x(), radius * direction.y()));
  };
  add(turned(directions_[0], axis));
  add(turned(directions_[wedges_], axis));
  const double half_cosine = aperture_ < 2.0 * M_PI ? directions_[0].x() : -1.0;
  if (axis.x() >= half_cosine) add({1.0, 0.0});
  if (axis.y() >= half_cosine) add({0.0, 1.0});
  if (-axis.x() >= half_cosine) add({-1.0, 0.0});
  if (-axis.y() >= half_cosine) add({0.0, -1.0});
  const auto cell = [](std::int64_t fine) {
    return static_cast<std::int32_t>(fine >> Footprint::kFineLog2);
  };
  covered_ = {{cell(apex_.x + bounds.min.x), cell(apex_.y + bounds.min.y)},
              {cell(apex_.x + bounds.max.x) + 1, cell(apex_.y + bounds.max.y) + 1}};
  return covered_.width() <= Footprint::kMaxSide && covered_.height() <= Footprint::kMaxSide;
}

CellRect EchoCone::apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const {
  const Cell first = tile_of(covered_.min);
  const Cell last = tile_of({covered_.max.x - 1, covered_.max.y - 1});
  bool is_empty = true;
  TileBits free;
  TileBits occupied;
  for (int y = first.y; y <= last.y; ++y) {
    const auto begin = static_cast<std::size_t>(std::max(0, covered_.min.y - y * kSide));
    const auto end = static_cast<std::size_t>(std::min(kSide, covered_.max.y - y * kSide));
    for (int x = first.x; x <= last.x; ++x) {
      if (!draw_rows(rows_, from_tile(apex_.x, x), from_tile(apex_.y, y), begin, end, free,
                     occupied)) {
        continue;
      }
      TileMap::Tile& tile = map.at({x, y});
      tile.revision = revision;
      is_empty = false;
      update_cells(tile, free, occupied, begin, end, update);
    }
  }
  return is_empty ? CellRect{} : covered_;
}

}  // namespace portolan
