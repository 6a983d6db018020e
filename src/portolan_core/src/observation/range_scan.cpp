// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_scan.hpp"

#include <cmath>

namespace portolan {

namespace {

constexpr double kWidest = 20.0 * M_PI;  // of angles [rad]: ten turns; degrees are beyond

}  // namespace

bool is_usable(const RangeScan& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max);
  if (!finite || scan.angle_increment == 0.0 || scan.ranges.empty()) return false;
  const double sweep = scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
  return std::abs(scan.angle_min) <= kWidest && std::abs(sweep) <= kWidest &&
         scan.range_min >= 0.0 && scan.range_min <= scan.range_max && is_valid(scan.T_first_last);
}

}  // namespace portolan
