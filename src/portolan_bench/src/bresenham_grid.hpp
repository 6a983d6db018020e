// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawer.hpp"

namespace portolan::bench {

/// A plain grid of saturating bytes with one Bresenham line per beam; it has no cones.
Drawer bresenham_grid(const Workload& workload);

}  // namespace portolan::bench
