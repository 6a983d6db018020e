// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "portolan/options.hpp"

namespace portolan {

/// Where the optimiser starts from.
enum class GraphStart {
  best,           ///< the best of the others, and the next best for a second opinion
  as_given,       ///< the poses as they are: for a graph that was consistent before its last arcs
  spanning_tree,  ///< along the surest arcs
  rotations,      ///< orientations by linear least squares first, then positions
};

constexpr std::array<const char*, 4> enum_names(GraphStart) {
  return {"best", "as_given", "spanning_tree", "rotations"};
}

/// How arcs lose weight that do not fit.
enum class RobustKernel {
  none,
  huber,
  cauchy,
  geman_mcclure,  ///< graduated from convex, so that the start does not decide which arcs are wrong
};

constexpr std::array<const char*, 4> enum_names(RobustKernel) {
  return {"none", "huber", "cauchy", "geman_mcclure"};
}

/// How a `GraphOptimizer` works; it calls them `Options`.
struct OptimizerOptions {
  GraphStart start = GraphStart::best;
  RobustKernel kernel = RobustKernel::none;
  double kernel_width = 3.0;
  std::size_t max_iterations = 100;
  double tolerance = 1e-6;
  double poor_fit = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("start", self.start, "where to start from");
    visit("kernel", self.kernel, "how arcs lose weight that do not fit; never those of odometry");
    visit("kernel_width", self.kernel_width, "standard deviations off, from which they do",
          above(0.0));
    visit("max_iterations", self.max_iterations, "of Gauss-Newton, from each start", at_least(1.0));
    visit("tolerance", self.tolerance, "part of chi-squared not worth another iteration",
          between(0.0, 0.01));
    visit("poor_fit", self.poor_fit, "chi-squared per degree of freedom, from which to doubt",
          above(0.0));
  }
};

}  // namespace portolan
