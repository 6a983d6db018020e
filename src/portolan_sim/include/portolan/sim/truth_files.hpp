// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "portolan/map_file.hpp"
#include "portolan/pose.hpp"
#include "portolan/sim/truth_grid.hpp"
#include "portolan/sim/world.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

/// A path as it really was.
using Trajectory = std::vector<std::pair<Time, Pose>>;

/// The grid as `<name>.yaml` and `<name>.pgm`.
FileSet grid_files(const std::string& name, const TruthGrid& grid);

/// `landmarks.yaml` and `beacons.yaml` in the format of the mappers' files, covariances zero.
FileSet mark_files(const World& world);

/// One line a pose, `stamp tx ty tz qx qy qz qw` (TUM).
std::string to_tum(const Trajectory& trajectory);

}  // namespace portolan::sim
