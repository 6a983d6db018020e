// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/BeaconMap.h>
#include <visualization_msgs/MarkerArray.h>

namespace portolan::ros_convert {

/// What rviz shows of the map: each mode as an ellipsoid of so many standard deviations, the
/// heavier the less transparent, its beacon's id over the heaviest, and an arrow from the antenna
/// to where it should drive. Orange as long as the beacon is ambiguous, then green. The first
/// marker removes those of the message before.
visualization_msgs::MarkerArray beacon_markers(const portolan_msgs::BeaconMap& map,
                                               double standard_deviations);

}  // namespace portolan::ros_convert
