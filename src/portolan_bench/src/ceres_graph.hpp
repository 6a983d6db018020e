// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/graph.hpp"

namespace portolan::bench {

/// Moves the poses of a graph as Ceres does, with automatic derivatives and its sparse Cholesky.
void optimize_with_ceres(Graph& graph);

}  // namespace portolan::bench
