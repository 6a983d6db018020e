// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "beacon_workload.hpp"

namespace portolan::bench {

/// The ranges of a bag (portolan_msgs/BeaconRanges, on any topic), each from where tf has its
/// antenna in `odom` at its stamp; what tf cannot pose is left out. Throws what rosbag throws, and
/// std::runtime_error with the path where nothing is left.
BeaconWorkload beacon_bag(const std::string& path);

}  // namespace portolan::bench
