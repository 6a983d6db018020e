// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/time.hpp"

namespace portolan {

/// Notices that a clock ran back: a bag that loops, a simulator that was restarted.
class ClockGuard {
 public:
  /// Steps back of no more than `tolerance` do not count.
  explicit ClockGuard(Duration tolerance) : tolerance_(tolerance) {}

  /// Takes the time that it is now; true where it lies before the newest time seen so far. Then
  /// the new time is the one that counts.
  bool ran_back(Time now);

 private:
  Duration tolerance_;
  std::optional<Time> newest_;
};

}  // namespace portolan
