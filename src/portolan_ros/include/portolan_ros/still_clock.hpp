// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>

#include "portolan/time.hpp"

namespace portolan {

/// Tells when ROS time stands: a bag has ended, or a simulator is paused.
class StillClock {
 public:
  using RealTime = std::chrono::steady_clock::time_point;

  /// Time that has been the same for so long stands; slow replays tick more often.
  static constexpr std::chrono::seconds kPatience{1};

  /// Takes the time that it is now, and when that is; true where it stands.
  bool stands(Time now, RealTime real);

 private:
  std::optional<Time> now_;
  RealTime since_{};
};

}  // namespace portolan
