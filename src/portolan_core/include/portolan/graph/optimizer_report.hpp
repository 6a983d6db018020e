// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "portolan/graph/optimizer_options.hpp"

namespace portolan {

/// A reason not to believe that coordinates are the best ones.
enum class Doubt {
  not_converged,    ///< still improving when the iterations ran out, or no step improved it
  undetermined,     ///< arcs leave some pose free to move
  disconnected,     ///< parts of the graph that no arc connects
  bad_information,  ///< arcs were left out because their information is none
  poor_fit,         ///< chi-squared far above the degrees of freedom: wrong arcs or wrong minimum
  wound_up,  ///< turns round a loop end a whole turn off, or may; an arc is turned by over 90 deg
  other_minimum,  ///< other starts ended elsewhere
};

constexpr std::array<const char*, 7> enum_names(Doubt) {
  return {"not_converged", "undetermined", "disconnected", "bad_information",
          "poor_fit",      "wound_up",     "other_minimum"};
}

/// What came of an optimisation.
struct OptimizerReport {
  double chi2_before = 0.0;
  double chi2 = 0.0;  ///< sum of residual^T information residual over accepted arcs
  double cost = 0.0;  ///< what the kernel makes of it: this is what was minimised
  std::size_t degrees_of_freedom = 0;
  std::size_t iterations = 0;
  std::size_t factorizations = 0;
  GraphStart start = GraphStart::as_given;  ///< the one whose end was taken
  std::set<Doubt> doubts;                   ///< empty: no reason to doubt the optimum
  std::vector<double> weights;              ///< by arc, that the kernel left it; 0 if not accepted
};

/// The doubts in words, separated by commas; "none".
std::string to_string(const std::set<Doubt>& doubts);

}  // namespace portolan
