// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/correction.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace portolan {

namespace {

bool not_increasing(const Correction::Knot& a, const Correction::Knot& b) {
  return a.stamp >= b.stamp;
}

}  // namespace

Correction::Correction(std::vector<Knot> knots) : knots_(std::move(knots)) {
  if (std::adjacent_find(knots_.begin(), knots_.end(), not_increasing) != knots_.end()) {
    throw std::invalid_argument("the stamps of a correction must increase");
  }
  const auto valid = [](const Knot& knot) { return is_valid(knot.T_map_odom); };
  if (!std::all_of(knots_.begin(), knots_.end(), valid)) {
    throw std::invalid_argument("a pose of the correction is not a finite rigid motion");
  }
}

Pose Correction::at(Time t) const {
  if (knots_.empty()) return Pose::Identity();
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), t,
                                      [](Time s, const Knot& knot) { return s < knot.stamp; });
  if (after == knots_.begin()) return knots_.front().T_map_odom;
  const auto before = std::prev(after);
  if (after == knots_.end()) return before->T_map_odom;
  const double fraction = to_seconds(t - before->stamp) / to_seconds(after->stamp - before->stamp);
  return interpolate(before->T_map_odom, after->T_map_odom, fraction);
}

}  // namespace portolan
