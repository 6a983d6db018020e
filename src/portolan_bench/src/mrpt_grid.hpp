// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawer.hpp"

namespace portolan::bench {

/// MRPT's COccupancyGridMap2D with thin rays, or with beams that widen with distance.
Drawer mrpt_grid(const Workload& workload, bool widening);

}  // namespace portolan::bench
