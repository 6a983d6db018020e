// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/Range.h>

#include <optional>

#include "portolan/observation/range_echo.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan_ros/sensed.hpp"

namespace portolan::ros_convert {

/// None where the message is malformed: no usable angles or limits, or a sweep that would take
/// less than no time or more than ten seconds.
std::optional<Sensed<RangeScan>> range_scan(const sensor_msgs::LaserScan& message);

/// None where aperture or limits are malformed.
std::optional<Sensed<RangeEcho>> range_echo(const sensor_msgs::Range& message);

}  // namespace portolan::ros_convert
