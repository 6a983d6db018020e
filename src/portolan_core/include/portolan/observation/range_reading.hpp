// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace portolan {

/// What a number that a range sensor sent says about the world (REP 117).
enum class RangeReading {
  hit,               ///< something stands at this range
  nothing_returned,  ///< nothing stands within the sensor's reach
  no_information,    ///< too close, not a number, or otherwise silent
};

constexpr std::array<const char*, 3> enum_names(RangeReading) {
  return {"hit", "nothing_returned", "no_information"};
}

/// The meaning of `range` [m] for a sensor that measures from `range_min` to `range_max` [m].
/// NaN, -Inf, 0 and less than `range_min` say nothing; +Inf and `range_max` or more: nothing
/// returned. Where both limits are equal the sensor only tells -Inf from +Inf, and a finite range
/// says nothing.
RangeReading range_reading(double range, double range_min, double range_max);

/// What a mapper makes of a reading in which nothing returned.
enum class NoReturn {
  ignore,  ///< nothing: the sensor may have failed to see something
  clear,   ///< all is free up to the usable range
};

constexpr std::array<const char*, 2> enum_names(NoReturn) { return {"ignore", "clear"}; }

}  // namespace portolan
