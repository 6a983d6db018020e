// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawer.hpp"

namespace portolan::bench {

/// GridMapper with its default options, but the workload's usable range.
Drawer our_grid(const Workload& workload);

/// The options of that.
GridOptions our_options(double max_range);

}  // namespace portolan::bench
