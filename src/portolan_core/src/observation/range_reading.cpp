// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_reading.hpp"

#include <cmath>

namespace portolan {

RangeReading range_reading(double range, double range_min, double range_max) {
  if (std::isnan(range) || range <= 0.0) return RangeReading::no_information;
  if (std::isinf(range)) return RangeReading::nothing_returned;
  const bool tells_ranges = range_min < range_max;
  if (!tells_ranges || range < range_min) return RangeReading::no_information;
  return range < range_max ? RangeReading::hit : RangeReading::nothing_returned;
}

}  // namespace portolan
