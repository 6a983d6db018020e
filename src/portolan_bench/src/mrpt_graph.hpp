// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "portolan/graph/graph.hpp"

namespace portolan::bench {

/// MRPT's optimiser on the same graph: each call starts anew and gives the graph that it ends with.
/// Reading the graph in is not part of a call.
std::function<void()> mrpt_optimizer(const Graph& graph, Graph& result);

}  // namespace portolan::bench
