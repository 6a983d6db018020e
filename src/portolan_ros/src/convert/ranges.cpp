// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/ranges.hpp"

#include <algorithm>
#include <limits>

#include "portolan_ros/convert/basics.hpp"

namespace portolan::ros_convert {

namespace {

// Some drivers say infinity for a sensor without a limit; NaN remains and is found to be unusable.
float limited(float range_max) { return std::min(range_max, std::numeric_limits<float>::max()); }

}  // namespace

std::optional<Sensed<RangeScan>> range_scan(const sensor_msgs::LaserScan& message) {
  constexpr double kLongestSweep = 10.0;  // [s]
  RangeScan scan;
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.range_min = message.range_min;
  scan.range_max = limited(message.range_max);
  scan.ranges = message.ranges;
  if (!is_usable(scan)) return std::nullopt;
  const double sweep = message.time_increment * static_cast<double>(scan.ranges.size() - 1);
  if (!(sweep >= 0.0 && sweep <= kLongestSweep)) return std::nullopt;
  const Time first = time(message.header.stamp);
  return Sensed<RangeScan>{message.header.frame_id, first, first + seconds(sweep), std::move(scan)};
}

std::optional<Sensed<RangeEcho>> range_echo(const sensor_msgs::Range& message) {
  const RangeEcho echo{message.range, message.min_range, limited(message.max_range),
                       message.field_of_view};
  if (!is_usable(echo)) return std::nullopt;
  const Time stamp = time(message.header.stamp);
  return Sensed<RangeEcho>{message.header.frame_id, stamp, stamp, echo};
}

}  // namespace portolan::ros_convert
