// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace portolan {

/// One distance measured to one identified beacon (radio, ultrasonic, UWB).
struct BeaconRange {
  std::uint32_t id = 0;  ///< identity that the beacon transmits
  double range = 0.0;    ///< from the antenna, the origin of the sensor's frame [m]
  double stddev = 0.0;   ///< one sigma of range; 0: unknown, the mapper uses its own model [m]
};

/// The ranges that one antenna measured at one moment.
struct BeaconRanges {
  std::vector<BeaconRange> ranges;
};

/// True where the range is finite and positive, the deviation not negative, and neither beyond the
/// limits of `limits.hpp`; whether the range is too long is for the mapper to say.
bool is_usable(const BeaconRange& range);

/// True unless every range is malformed: the good ones are used, the others counted. No range at
/// all is nothing wrong.
bool is_usable(const BeaconRanges& ranges);

/// What they occupy in memory [byte].
inline std::size_t byte_size(const BeaconRanges& ranges) {
  return sizeof(ranges) + ranges.ranges.capacity() * sizeof(BeaconRange);
}

}  // namespace portolan
