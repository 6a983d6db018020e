// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "portolan/time.hpp"

namespace portolan {

/// What to think of a stamp, after those before it.
enum class StampVerdict {
  good,      ///< it goes on from those before it
  doubtful,  ///< it leaps away from them; perhaps it alone
  ran_back,  ///< it is the second that leapt to the same time, and that time lies in the past
};

constexpr std::array<const char*, 3> enum_names(StampVerdict) {
  return {"good", "doubtful", "ran_back"};
}

/// Tells a clock that was set anew from a lone wild stamp: a leap counts once the next stamp goes
/// on from it. So neither one wild stamp nor a second sender with a wrong clock can undo anything.
class LeapGuard {
 public:
  /// Stamps no further apart than `tolerance` do not leap.
  explicit LeapGuard(Duration tolerance) : tolerance_(tolerance) {}

  StampVerdict judge(Time stamp);

 private:
  bool are_close(Time a, Time b) const { return a - b <= tolerance_ && b - a <= tolerance_; }

  Duration tolerance_;
  std::optional<Time> newest_;
  std::optional<Time> doubtful_;
};

}  // namespace portolan
