// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/correction.hpp"
#include "portolan/time.hpp"
#include "portolan_ros/clock_guard.hpp"

namespace portolan {

/// Holds back a correction from the time after a jump that nobody here has noticed yet, so that it
/// moves nothing of the time before: whoever corrects may see the clock run back first.
class CorrectionGate {
 public:
  /// Takes a correction that was worked out at `stamp`, and gives it back where it counts at once.
  /// One whose stamp runs back, and all after it, wait for the clock here.
  std::optional<Correction> take(Correction correction, Time stamp, Time now);

  /// The one that waits, once a second has passed without a jump: only its sender's clock was set.
  std::optional<Correction> overdue(Time now);

  /// To be called when the clock here has run back: the one that waits, which counts from now on.
  std::optional<Correction> clock_ran_back();

 private:
  std::optional<Correction> let_pass();

  ClockGuard sender_clock_{seconds(0.1)};
  bool clock_ran_back_ = false;  // since the last correction
  std::optional<Correction> early_;
  Time since_{};
};

}  // namespace portolan
