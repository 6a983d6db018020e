// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/observation/range_scan.hpp"
#include "portolan/pose.hpp"

namespace portolan::bench {

/// MRPT's classic ICP of two scans, from a guess; T_target_source. With `tuned`, the parameters of
/// its icp-slam application, else the defaults.
Pose mrpt_icp(const RangeScan& target, const RangeScan& source, const Pose& T_guess, bool tuned);

}  // namespace portolan::bench
