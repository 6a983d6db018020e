// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graph/problem.hpp"

namespace portolan {

/// Whether some arc is turned by more than an angle [rad] beyond what was measured.
template <class Motion>
bool is_turned_beyond(double angle, const Problem<Motion>& problem,
                      const std::vector<typename Motion::State>& states);

/// True where chi^2 is much larger than measurement noise explains.
bool is_poor_fit(double chi2, std::size_t degrees_of_freedom, double factor);

}  // namespace portolan
