// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace portolan {

/// One distance measured to one beacon, which says who it is.
struct BeaconRange {
  std::uint32_t id = 0;
  double range = 0.0;   ///< from the antenna, the origin of the sensor's frame [m]
  double stddev = 0.0;  ///< one sigma; 0: unknown [m]
};

/// The ranges that one antenna measured in one moment.
struct BeaconRanges {
  std::vector<BeaconRange> ranges;
};

/// True where range (not below 0) and deviation (likewise) are finite.
bool is_usable(const BeaconRange& range);

/// True where every range is usable.
bool is_usable(const BeaconRanges& z);

/// What it occupies in memory [byte].
inline std::size_t byte_size(const BeaconRanges& z) {
  return sizeof(z) + z.ranges.capacity() * sizeof(BeaconRange);
}

}  // namespace portolan
