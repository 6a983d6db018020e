// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "workload.hpp"

namespace portolan::bench {

/// A way to draw a grid map: an empty map of 5 cm cells, and what draws into it.
struct Drawer {
  std::function<void(std::size_t scan)> scan;
  std::function<void(const RangeEcho& echo)> echo;  ///< from the origin
};

}  // namespace portolan::bench
