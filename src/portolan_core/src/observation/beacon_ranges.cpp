// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/beacon_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

bool is_usable(const BeaconRange& range) {
  return std::isfinite(range.range) && range.range >= 0.0 && std::isfinite(range.stddev) &&
         range.stddev >= 0.0;
}

bool is_usable(const BeaconRanges& z) {
  return std::all_of(z.ranges.begin(), z.ranges.end(),
                     [](const BeaconRange& range) { return is_usable(range); });
}

}  // namespace portolan
