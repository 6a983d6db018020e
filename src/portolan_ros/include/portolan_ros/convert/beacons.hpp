// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/BeaconMap.h>
#include <portolan_msgs/BeaconRanges.h>

#include <optional>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan_ros/sensed.hpp"

namespace portolan::ros_convert {

/// None where every range of the message is malformed; single ones are left to the mapper, which
/// counts them.
std::optional<Sensed<BeaconRanges>> beacon_ranges(const portolan_msgs::BeaconRanges& message);

/// All that the mapper knows. Header: left to the caller.
portolan_msgs::BeaconMap beacon_map(const BeaconMapper& mapper);

}  // namespace portolan::ros_convert
