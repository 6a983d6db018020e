// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/sim/world_options.hpp"

namespace portolan::sim {

/// Reads a world from YAML: one of ours, or the YAML + PGM pair of map_server, whose occupied cells
/// become blocks `wall_height` [m] high. Throws std::runtime_error that names the file and what is
/// wrong with it.
WorldOptions read_world(const std::string& path, double wall_height = 2.5);

}  // namespace portolan::sim
