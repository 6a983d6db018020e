// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_scan.hpp"

#include <cmath>

namespace portolan {

bool is_usable(const RangeScan& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max);
  return finite && scan.angle_increment != 0.0 && !scan.ranges.empty() && scan.range_min >= 0.0 &&
         scan.range_min <= scan.range_max && is_valid(scan.T_first_last);
}

}  // namespace portolan
