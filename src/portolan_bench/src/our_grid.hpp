// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawer.hpp"

namespace portolan::bench {

/// Whether walls are given a depth, as they are by default, or none, as the peers do it.
enum class Margin { none, by_default };

/// GridMapper with its default options, but the workload's usable range.
Drawer our_grid(const Workload& workload, Margin margin);

/// The options of that.
GridOptions our_options(double max_range, Margin margin);

}  // namespace portolan::bench
