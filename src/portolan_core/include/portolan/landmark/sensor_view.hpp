// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "portolan/pose.hpp"

namespace portolan {

/// Where a sensor sees landmarks and where it doesn't, learnt from those that are known: a
/// landmark that is not seen tells nothing where the sensor rarely sees any.
class SensorView {
 public:
  /// True where the sensor has moved or turned enough since it last said so that what it misses
  /// now is news, and for the first pose.
  bool is_news(const Pose& T_map_sensor);

  /// Takes note that a landmark at `l`, with axes as in REP 103 [m], was seen or was not.
  void note(const Eigen::Vector3d& l, bool seen);

  /// P(a landmark there is seen), careful: 0 where nothing is known of this direction so far out.
  double p_detection(const Eigen::Vector3d& l) const;

  /// How far it has been seen to see [m].
  double reach() const { return reach_; }
  void reach_to(double distance) { reach_ = distance > reach_ ? distance : reach_; }

 private:
  static constexpr std::size_t kAzimuths = 24;
  static constexpr std::size_t kElevations = 6;
  static constexpr std::size_t kRanges = 8;
  struct Count {
    float seen = 0.0F;
    float missed = 0.0F;
  };

  static std::size_t bin(const Eigen::Vector3d& l);

  std::array<Count, kAzimuths * kElevations * kRanges> counts_{};
  double reach_ = 0.0;
  std::optional<Pose> T_map_last_;
};

}  // namespace portolan
