// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace portolan {

/// The clock of the data: stamps count nanoseconds since the epoch that the recording uses.
/// Nobody can ask it what time it is now, so nothing in the core depends on when it runs.
struct DataClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<DataClock, duration>;
  static constexpr bool is_steady = false;  // NOLINT(readability-identifier-naming): std's name
};

using Duration = DataClock::duration;
using Time = DataClock::time_point;

/// A duration of so many seconds, to the nearest nanosecond; less than 292 years either way [s].
constexpr Duration seconds(double s) {
  return Duration(static_cast<Duration::rep>(s * 1e9 + (s < 0.0 ? -0.5 : 0.5)));
}

/// The duration in seconds [s].
constexpr double to_seconds(Duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace portolan
