// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/beacon_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/limits.hpp"

namespace portolan {

bool is_usable(const BeaconRange& range) {
  return std::isfinite(range.range) && range.range >= kSharpestDistance &&
         is_deviation(range.stddev, kWidestDistance);
}

bool is_usable(const BeaconRanges& ranges) {
  const auto usable = [](const BeaconRange& range) { return is_usable(range); };
  return ranges.ranges.empty() || std::any_of(ranges.ranges.begin(), ranges.ranges.end(), usable);
}

}  // namespace portolan
