// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "graph/block_cholesky.hpp"
#include "graph/normal_equations.hpp"

namespace portolan {

/// Whether poses are turned within 0.1 rad of each other's everywhere.
template <class Motion>
bool are_turned_alike(const Problem<Motion>& problem, const std::vector<typename Motion::State>& a,
                      const std::vector<typename Motion::State>& b);

/// Goes downhill from given coordinates by Gauss-Newton steps; where one fails, by two at once or
/// shorter ones, and where those fail, damped after Levenberg.
template <class Motion>
class GaussNewton {
 public:
  using States = std::vector<typename Motion::State>;

  struct Limits {
    std::size_t max_iterations = 100;
    double tolerance = 1e-6;        ///< of the cost, not worth another iteration
    double known_minimum = -1.0;    ///< stop within 0.05 % of this cost: it leads there too
    const States* known = nullptr;  ///< and where poses are turned as in this minimum
  };

  struct Descent {
    double cost = 0.0;
    std::size_t iterations = 0;
    std::size_t factorizations = 0;
    bool converged = false;
    bool known = false;           ///< stopped on the way to the known minimum
    double smallest_pivot = 1.0;  ///< of the last factor, undamped
  };

  /// Both must outlive it.
  GaussNewton(const Problem<Motion>& problem, const BlockPattern& pattern)
      : problem_(problem), equations_(problem), cholesky_(pattern, problem.pairs) {}

  /// The cost is that of the states.
  Descent descend(States& states, double cost, const Kernel& kernel, const Limits& limits);

 private:
  bool improve(States& states, const Kernel& kernel, const Limits& limits, Descent& descent);
  bool is_near(const Descent& descent) const;
  bool improve_with_kept_factor(States& states, const Kernel& kernel, double enough,
                                Descent& descent);
  bool solve(Descent& descent);
  bool solve_with_factor();
  double promise() const { return -equations_.g.dot(step_); }
  void damp();
  double left_after(double promise, const Descent& descent);
  bool leads_to_known(const Limits& limits, const States& states, double cost) const;
  bool moves(double share, States& states, const Kernel& kernel, Descent& descent);
  bool moves_some(States& states, const Kernel& kernel, Descent& descent);
  bool overshoots(States& states, const Kernel& kernel, Descent& descent);
  void move(const States& from, double share, States& to) const;

  const Problem<Motion>& problem_;
  NormalEquations<Motion> equations_;
  BlockCholesky<Motion::kSize> cholesky_;
  Eigen::VectorXd step_;
  States tried_;
  double damping_ = 0.0;
  double last_promise_ = 0.0;  // of an undamped step before this one; 0: none
  int full_steps_ = 0;         // one after the other
  bool may_overshoot_ = true;
};

}  // namespace portolan
