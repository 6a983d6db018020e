// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graph/problem.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {

/// Whether some arc is turned by more than an angle [rad] beyond what was measured.
template <class Motion>
bool is_turned_beyond(double angle, const Problem<Motion>& problem,
                      const std::vector<typename Motion::State>& states);

/// True where no arcs connect parts of a graph and not each of them has a fixed pose: there are
/// more roots than fixed poses, or none of these and more than one.
bool is_disconnected(const Graph& graph, const SpanningTree& tree);

/// True where chi^2 is much larger than measurement noise explains.
bool is_poor_fit(double chi2, std::size_t degrees_of_freedom, double factor);

}  // namespace portolan
