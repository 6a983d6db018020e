// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/local_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

enum class Sight { nothing, agrees, through };

// The range that a beam read, where it says something of its direction: beyond reach is far away.
double reach_of(const RangeScan& scan, std::size_t beam) {
  const double range = static_cast<double>(scan.ranges[beam]);
  return range_reading(range, scan.range_min, scan.range_max) == RangeReading::hit ? range : 0.0;
}

// What the two beams beside the point say; between different ranges anything may be.
Sight sight(const View& view, const Eigen::Vector3d& p_map, double margin) {
  const Eigen::Vector3d p = view.T_map_sensor.inverse() * p_map;
  const double range = p.head<2>().norm();
  const double turns = std::atan2(p.y(), p.x()) - view.scan->angle_min;
  const double step = view.scan->angle_increment;
  const double whole = 2.0 * M_PI;
  const double along = step > 0.0 ? turns - whole * std::floor(turns / whole)
                                  : turns - whole * std::ceil(turns / whole);
  const double beam = along / step;
  if (beam + 1.0 >= static_cast<double>(view.scan->ranges.size())) return Sight::nothing;
  const auto left = static_cast<std::size_t>(beam);
  const double a = reach_of(*view.scan, left);
  const double b = reach_of(*view.scan, left + 1);
  if (a == 0.0 || b == 0.0) return Sight::nothing;
  const double slack = margin + 0.5 * std::abs(step) * range;
  if (range < std::min(a, b) - slack) return Sight::through;
  return range <= std::max(a, b) + slack ? Sight::agrees : Sight::nothing;
}

// One view that agrees is enough; one that sees through counts where none does.
Sight sight(const LocalMap& map, const Eigen::Vector3d& p_map, double margin) {
  Sight best = Sight::nothing;
  for (const View& view : map.views) {
    const Sight one = sight(view, p_map, margin);
    if (one == Sight::agrees) return one;
    if (one == Sight::through) best = one;
  }
  return best;
}

struct Tally {
  double all = 0.0;
  double agree = 0.0;
  double through = 0.0;

  void add(const Surface& surface, const Pose& T_map_surface, const LocalMap& map, double margin) {
    for (const Eigen::Vector3d& p : surface.points) {
      const Sight one = sight(map, T_map_surface * p, margin);
      all += 1.0;
      agree += one == Sight::agrees ? 1.0 : 0.0;
      through += one == Sight::through ? 1.0 : 0.0;
    }
  }
};

void flatten(Surface& surface) {
  for (Eigen::Vector3d& p : surface.points) p.z() = 0.0;
}

}  // namespace

void LocalMapMaker::add(const Keyframe& keyframe, const Pose& T_map_base) {
  constexpr double kFurthest = 200.0;  // [m]; false of what is not a number
  if (!(T_map_base.translation().norm() <= kFurthest)) return;
  if (keyframe.scan.ranges.empty()) return;
  const Pose T_map_sensor = T_map_base * keyframe.T_base_sensor;
  append(scan_surface(keyframe.scan, options_), T_map_sensor, map_.surface);
  map_.views.push_back({&keyframe.scan, T_map_sensor});
}

LocalMap LocalMapMaker::make() && {
  flatten(map_.surface);
  map_.surface = thinned(map_.surface, options_.spacing);
  return std::move(map_);
}

Agreement agreement(const LocalMap& a, const LocalMap& b, const Pose& T_a_b, double margin) {
  Tally of_b;
  of_b.add(b.surface, T_a_b, a, margin);
  Tally both = of_b;
  both.add(a.surface, T_a_b.inverse(), b, margin);
  return {(of_b.agree + of_b.through) / std::max(1.0, of_b.all),
          both.agree / std::max(1.0, both.agree + both.through)};
}

}  // namespace portolan
