// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "graph/block_cholesky.hpp"
#include "graph/normal_equations.hpp"

namespace portolan {

/// Goes downhill from given coordinates by Gauss-Newton steps; where one fails, by shorter ones,
/// and where those fail, damped after Levenberg.
template <class Motion>
class GaussNewton {
 public:
  using States = std::vector<typename Motion::State>;

  struct Limits {
    std::size_t max_iterations = 100;
    double tolerance = 1e-8;      ///< of the cost, not worth another iteration
    double known_minimum = -1.0;  ///< stop within 0.05 % of this cost: it leads there too
  };

  struct Descent {
    double cost = 0.0;
    std::size_t iterations = 0;
    std::size_t factorizations = 0;
    bool converged = false;
    double smallest_pivot = 1.0;  ///< of the last factor, undamped
  };

  /// Both must outlive it.
  GaussNewton(const Problem<Motion>& problem, const BlockPattern& pattern)
      : problem_(problem), equations_(problem), cholesky_(pattern, equations_.H) {}

  Descent descend(States& states, const Kernel& kernel, const Limits& limits);

 private:
  bool improve(States& states, const Kernel& kernel, const Limits& limits, Descent& descent);
  bool solve(Descent& descent);
  bool step(States& states, const Kernel& kernel, Descent& descent);
  void move(const States& from, double share, States& to) const;

  const Problem<Motion>& problem_;
  NormalEquations<Motion> equations_;
  BlockCholesky<Motion::kSize> cholesky_;
  Eigen::VectorXd step_;
  States tried_;
  double damping_ = 0.0;
};

}  // namespace portolan
