// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/graph/uncertainty.hpp"

namespace portolan {

/// A way between two keyframes: the one measured from the other.
struct Link {
  std::size_t from = 0;
  std::size_t to = 0;
  UncertainPose T_from_to;
};

/// Where all keyframes lie as seen from one of them, along the surest ways: dead reckoning through
/// the graph by Dijkstra's algorithm, covariances compounded along the tree (chapter 8; Olson
/// 2009). None for those that no way leads to.
std::vector<std::optional<UncertainPose>> reckon(const std::vector<Link>& links, std::size_t count,
                                                 std::size_t root);

}  // namespace portolan
