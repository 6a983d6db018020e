// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graph/neighbours.hpp"

namespace portolan {

/// By node: when to eliminate it, so that the Cholesky factor of a matrix with entries where nodes
/// are neighbours fills up little. Nodes on chains come first, along them, then the others by
/// approximate minimum degree.
std::vector<int> elimination_order(const Neighbours& graph);

}  // namespace portolan
