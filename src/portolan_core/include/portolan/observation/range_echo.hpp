// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace portolan {

/// One echo of a sonar, or of any ranger that hears a cone about its x axis.
struct RangeEcho {
  double range = 0.0;      ///< [m]; see `range_reading` for what odd values mean
  double range_min = 0.0;  ///< [m]
  double range_max = 0.0;  ///< [m]
  double aperture = 0.0;   ///< full angle of the cone, the chapter's beta [rad]
};

/// True where limits and aperture are finite and make sense; the range may be anything.
bool is_usable(const RangeEcho& echo);

/// What it occupies in memory [byte].
inline std::size_t byte_size(const RangeEcho& echo) { return sizeof(echo); }

}  // namespace portolan
