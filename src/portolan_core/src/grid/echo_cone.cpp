// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/echo_cone.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

// The radii in which cells are free, and from there on occupied [m].
struct Rings {
  double free = 0.0;
  double occupied = 0.0;
};

Rings rings(const RangeEcho& echo, const SonarModel& model) {
  const double reach = std::min(model.max_range, echo.range_max);
  switch (range_reading(echo.range, echo.range_min, echo.range_max)) {
    case RangeReading::no_information:
      return {};
    case RangeReading::nothing_returned:
      return model.no_return == NoReturn::clear ? Rings{reach, 0.0} : Rings{};
    case RangeReading::hit:
      break;
  }
  if (echo.range > model.max_range) return {reach, 0.0};
  return {std::max(0.0, echo.range - model.margin), echo.range + model.margin};
}

// The cell that lies so far from there [1/1024 cell].
std::int32_t cell(std::int64_t from, double by) {
  return static_cast<std::int32_t>((from + static_cast<std::int64_t>(by)) >> Footprint::kFineLog2);
}

}  // namespace

EchoCone::EchoCone(const GridOptions& options)
    : grid_(options.resolution),
      model_(options.sonar),
      side_(options.resolution),
      least_level_(std::cos(options.max_tilt)) {
  model_.margin = std::max(model_.margin, side_ / 2.0);
}

Outcome EchoCone::place(const RangeEcho& echo, const Pose& T_map_sensor) {
  if (!is_usable(echo)) return Outcome::unusable;
  const double x = T_map_sensor(0, 0);
  const double y = T_map_sensor(1, 0);
  const double level = std::sqrt(x * x + y * y);
  if (level < least_level_) return Outcome::rejected;
  if (echo.aperture != aperture_) look_up(echo.aperture);
  const Rings seen = rings(echo, model_);
  const std::int64_t free = grid_.length(seen.free * level);
  const std::int64_t reach = std::max(free, grid_.length(seen.occupied * level));
  rows_.apex = grid_.anchor(T_map_sensor.translation());
  rows_.set_radii(free, reach);
  place_wedges({x / level, y / level}, static_cast<double>(reach));
  const CellRect& covered = rows_.covered;
  const bool fits =
      covered.width() <= Footprint::kMaxSide && covered.height() <= Footprint::kMaxSide;
  return fits ? Outcome::inserted : Outcome::unusable;
}

void EchoCone::look_up(double aperture) {
  aperture_ = aperture;
  wedges_ = static_cast<std::size_t>(std::ceil(aperture / (M_PI / 2.0)));
  for (std::size_t i = 0; i <= wedges_; ++i) {
    const double angle = aperture * (static_cast<double>(i) / static_cast<double>(wedges_) - 0.5);
    sides_[i] = {std::cos(angle), std::sin(angle)};
  }
  const bool is_round = aperture >= 2.0 * M_PI;
  if (is_round) sides_[wedges_] = sides_[0];
  half_cosine_ = is_round ? -1.0 : sides_[0].x;
}

// Beyond its reach the wedges' sides go on [1/1024 cell].
void EchoCone::place_wedges(Direction axis, double reach) {
  const double radius = 1.5 * (reach / grid_.scale() + side_);
  const Direction first = sides_[0].turned(axis);
  Direction side = first;
  FinePoint right = grid_.point(radius * side.x, radius * side.y);
  rows_.count = 0;
  for (std::size_t i = 1; i <= wedges_; ++i) {
    side = sides_[i].turned(axis);
    const FinePoint left = grid_.point(radius * side.x, radius * side.y);
    rows_.add(right, left);
    right = left;
  }
  rows_.covered = {{cell(rows_.apex.x, -reach * extent(-axis.x, -first.x, -side.x)),
                    cell(rows_.apex.y, -reach * extent(-axis.y, -first.y, -side.y))},
                   {cell(rows_.apex.x, reach * extent(axis.x, first.x, side.x)) + 1,
                    cell(rows_.apex.y, reach * extent(axis.y, first.y, side.y)) + 1}};
}

// How far a cone of unit reach goes along an axis of the map.
double EchoCone::extent(double axis, double right, double left) const {
  return axis >= half_cosine_ ? 1.0 : std::max(0.0, std::max(right, left));
}

CellRect EchoCone::apply(TileMap& map, const CellUpdate& update, std::uint64_t revision) const {
  return rows_.apply(map, update, revision) ? rows_.covered : CellRect{};
}

}  // namespace portolan
