// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "workload.hpp"

namespace portolan::bench {

/// A way to draw a grid map of 5 cm cells, empty at first: draws a reading of the workload, by its
/// number.
using Drawer = std::function<void(std::size_t reading)>;

}  // namespace portolan::bench
