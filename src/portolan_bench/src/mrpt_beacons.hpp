// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "beacon_workload.hpp"

namespace portolan::bench {

/// MRPT's CBeaconMap as a sum of Gaussians, ready to run the whole workload from an empty map;
/// gives the mean of each beacon's heaviest Gaussian [m].
std::function<std::map<BeaconId, Eigen::Vector3d>()> mrpt_beacons(const BeaconWorkload& load);

/// The ranges of a rawlog of actions and sensory frames. Throws std::runtime_error with the path.
BeaconWorkload beacon_rawlog(const std::string& path);

}  // namespace portolan::bench
