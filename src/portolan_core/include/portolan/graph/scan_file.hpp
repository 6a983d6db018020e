// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/graph/arc.hpp"
#include "portolan/graph/keyframe.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// What a keyframe of a saved graph saw, so that its place can be found again.
struct SavedScan {
  PoseId keyframe = 0;
  Time stamp{};
  Pose T_base_sensor = Pose::Identity();
  RangeScan scan;
};

/// The keyframes' scans, those that are not forgotten, to the last bit: a line
/// `portolan scans 1 COUNT`, and then for each keyframe, least significant byte first:
///
///     int64    id, stamp [ns]
///     12 x 64  T_base_sensor, rows of [R t] [m]
///     12 x 64  the sensor's pose at the last beam, seen from the first one
///     4 x 64   angle_min, angle_increment [rad], range_min, range_max [m]
///     uint32   how many ranges, and each of them as a float of 32 bits [m]
std::string to_scan_file(const std::vector<Keyframe>& keyframes);

/// The scans of such a file. Throws std::runtime_error that says which scan is wrong and how: of
/// another version, cut off, out of order of ids, or with a pose or limits that make no sense.
std::vector<SavedScan> scans_from_file(const std::string& bytes);

}  // namespace portolan
