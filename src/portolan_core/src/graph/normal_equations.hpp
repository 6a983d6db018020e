// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "graph/block_matrix.hpp"
#include "graph/kernel.hpp"
#include "graph/problem.hpp"

namespace portolan {

/// H = sum of J^T W J and g = sum of J^T W r over the arcs of a graph, where W is the information
/// times the weight that the kernel leaves: what a Gauss-Newton step solves, H step = -g.
template <class Motion>
struct NormalEquations {
  explicit NormalEquations(const Problem<Motion>& problem)
      : H(problem.pose.size(), problem.pairs),
        g(static_cast<Eigen::Index>(problem.pose.size()) * Motion::kSize) {}

  void linearize(const Problem<Motion>& problem, const std::vector<typename Motion::State>& states,
                 const Kernel& kernel);

  /// g alone, which takes less.
  void add_up_gradient(const Problem<Motion>& problem,
                       const std::vector<typename Motion::State>& states, const Kernel& kernel);

  BlockMatrix<Motion::kSize> H;
  Eigen::VectorXd g;
};

/// Sum of what the kernel makes of r^T information r.
template <class Motion>
double cost(const Problem<Motion>& problem, const std::vector<typename Motion::State>& states,
            const Kernel& kernel);

}  // namespace portolan
