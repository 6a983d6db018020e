// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/pose_history.hpp"

#include <algorithm>
#include <iterator>

namespace portolan::sim {

void PoseHistory::add(Time stamp, const Pose& pose) {
  poses_.emplace_back(stamp, pose);
  // One pose older than the span stays, to interpolate from.
  while (poses_.size() > 2 && poses_[1].first < stamp - span_) poses_.pop_front();
}

Pose PoseHistory::at(Time stamp) const {
  const auto after = std::lower_bound(poses_.begin(), poses_.end(), stamp,
                                      [](const auto& pose, Time t) { return pose.first < t; });
  if (after == poses_.end()) return poses_.back().second;
  if (after == poses_.begin() || after->first == stamp) return after->second;
  const auto before = std::prev(after);
  const double fraction =
      to_seconds(stamp - before->first) / to_seconds(after->first - before->first);
  return interpolate(before->second, after->second, fraction);
}

}  // namespace portolan::sim
