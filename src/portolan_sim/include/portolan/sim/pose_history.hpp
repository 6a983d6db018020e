// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <utility>

#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

/// The latest poses of something that moves.
class PoseHistory {
 public:
  /// Forgets what is older than `span` before the newest pose.
  explicit PoseHistory(Duration span) : span_(span) {}

  /// Stamps must increase.
  void add(Time stamp, const Pose& pose);

  /// Between its neighbours; beyond either end the nearest one. Needs at least one pose.
  Pose at(Time stamp) const;

 private:
  Duration span_;
  std::deque<std::pair<Time, Pose>> poses_;
};

}  // namespace portolan::sim
