// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// How far odometry had drifted at each moment: T_map_odom as a function of time.
/// A whole snapshot and never a change to an earlier one, so the last one received is right.
class Correction {
 public:
  struct Knot {
    Time stamp;
    Pose T_map_odom;
  };

  /// No drift at all: the map frame is the odometry's.
  Correction() = default;

  /// Throws std::invalid_argument where stamps do not increase or a pose is not rigid.
  explicit Correction(std::vector<Knot> knots);

  /// T_map_odom at `t`: interpolated between its neighbours, constant before the first knot and
  /// after the last one, identity without any.
  Pose at(Time t) const;

  const std::vector<Knot>& knots() const { return knots_; }

 private:
  std::vector<Knot> knots_;  // by increasing stamp
};

}  // namespace portolan
