// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beacon_workload.hpp"

namespace portolan::bench {

/// MRPT's CBeaconMap as a sum of Gaussians, ready to run the whole workload from an empty map;
/// gives the mean of each beacon's heaviest Gaussian [m].
std::function<Places()> mrpt_beacons(const BeaconWorkload& load);

/// The ranges of a rawlog of actions and sensory frames, from its odometry or from the robot's
/// `poses` after each action, where there are any; then only as far as these go. Throws
/// std::runtime_error with the path.
BeaconWorkload beacon_rawlog(const std::string& path, const std::vector<Pose>& poses = {});

}  // namespace portolan::bench
