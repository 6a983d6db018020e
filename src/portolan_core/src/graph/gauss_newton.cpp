// SPDX-License-Identifier: BSD-3-Clause
#include "graph/gauss_newton.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr double kFirstDamping = 1e-4;
constexpr double kLeastDamping = 1e-6;  // below, there is none
constexpr double kMostDamping = 1e8;    // above, no step helps
constexpr double kShortestStep = 0.1;   // share of a step that is tried before damping
constexpr double kSame = 5e-4;          // relative difference of costs near a known minimum
constexpr double kNear = 1e-4;  // share of the cost left to win from which steps foretell the next
constexpr double kFastest = 1e-3;  // that what is left to win is expected to shrink by a step
// Up to which share of what the last step promised, or of the cost, its factor is good enough.
constexpr double kFast = 2e-4;
constexpr double kLittle = 1e-6;
constexpr double kTurnedTheSame = 0.995;  // cosine, of about 0.1 rad
constexpr double kNoCost = 1e-18;         // per arc: rounding

}  // namespace

template <class Motion>
bool are_turned_alike(const Problem<Motion>& problem, const std::vector<typename Motion::State>& a,
                      const std::vector<typename Motion::State>& b) {
  return std::all_of(problem.pose.begin(), problem.pose.end(), [&](std::size_t pose) {
    return Motion::cosine_between(a[pose], b[pose]) > kTurnedTheSame;
  });
}

template <class Motion>
typename GaussNewton<Motion>::Descent GaussNewton<Motion>::descend(States& states,
                                                                   const Kernel& kernel,
                                                                   const Limits& limits) {
  Descent descent;
  damping_ = 0.0;
  last_promise_ = 0.0;
  descent.cost = cost(problem_, states, kernel);
  while (!descent.converged && descent.iterations < limits.max_iterations) {
    descent.known = leads_to_known(limits, states, descent.cost);
    if (descent.known || !improve(states, kernel, limits, descent)) break;
  }
  return descent;
}

// Costs as much already, or is turned the same everywhere: positions follow from that.
template <class Motion>
bool GaussNewton<Motion>::leads_to_known(const Limits& limits, const States& states,
                                         double cost) const {
  if (std::abs(cost - limits.known_minimum) <= kSame * cost) return true;
  return limits.known != nullptr && are_turned_alike(problem_, states, *limits.known);
}

// One linearisation, and the first step from it that improves the cost. False if there is none.
template <class Motion>
bool GaussNewton<Motion>::improve(States& states, const Kernel& kernel, const Limits& limits,
                                  Descent& descent) {
  ++descent.iterations;
  equations_.linearize(problem_, states, kernel);
  while (damping_ <= kMostDamping) {
    if (!solve(descent)) {
      damp();
      continue;
    }
    // What the step promises, g^T H^-1 g, is all that is left to win near the minimum.
    const double promise = this->promise();
    const double rounding = kNoCost * static_cast<double>(problem_.terms.size());
    const bool undamped = damping_ == 0.0 || descent.smallest_pivot == 0.0;
    const double enough = limits.tolerance * descent.cost + rounding;
    descent.converged = undamped && left_after(promise, descent) <= enough;
    const double before = descent.cost;
    if (const double share = step(states, kernel, descent); share > 0.0) {
      // With a factor from before, a step leaves no more than it won less, or more, than promised.
      if (is_kept_) descent.converged = std::abs(promise - (before - descent.cost)) <= enough;
      descent.converged = descent.converged && (share == 1.0 || promise <= enough);
      damping_ = damping_ > kLeastDamping ? 0.1 * damping_ : 0.0;
      if (damping_ < kLeastDamping) damping_ = 0.0;
      return true;
    }
    descent.converged = undamped && promise <= enough;
    if (descent.converged) return true;
    if (is_kept_) {
      last_promise_ = 0.0;  // once more with a factor of its own
    } else {
      damp();
    }
  }
  return false;
}

template <class Motion>
void GaussNewton<Motion>::damp() {
  damping_ = std::max(kFirstDamping, 10.0 * damping_);
}

// What is left to win after a step: near the minimum it leaves as small a share of what it
// promised as it promises of what the last one did.
template <class Motion>
double GaussNewton<Motion>::left_after(double promise, const Descent& descent) {
  const double share = last_promise_ > 0.0 ? promise / last_promise_ : 1.0;
  last_promise_ = damping_ == 0.0 ? promise : 0.0;
  if (promise > kNear * descent.cost) return promise;
  return promise * std::clamp(share, kFastest, 1.0);
}

// With the last factor where that will do: near the minimum it hardly changes.
template <class Motion>
bool GaussNewton<Motion>::solve(Descent& descent) {
  is_kept_ = damping_ == 0.0 && last_promise_ > 0.0 && solve_with_factor() &&
             promise() <= std::max(kFast * last_promise_, kLittle * descent.cost);
  if (is_kept_) return true;
  ++descent.factorizations;
  if (!cholesky_.factor(equations_.H, damping_)) {
    descent.smallest_pivot = 0.0;
    return false;
  }
  if (damping_ == 0.0) descent.smallest_pivot = cholesky_.smallest_pivot();
  return solve_with_factor();
}

template <class Motion>
bool GaussNewton<Motion>::solve_with_factor() {
  step_ = -equations_.g;
  cholesky_.solve(step_);
  return step_.allFinite();
}

// Which share of the step improved the cost; 0 if none did.
template <class Motion>
double GaussNewton<Motion>::step(States& states, const Kernel& kernel, Descent& descent) {
  for (double share = 1.0; share >= kShortestStep; share *= 0.5) {
    move(states, share, tried_);
    const double tried = cost(problem_, tried_, kernel);
    if (!(tried < descent.cost)) continue;
    descent.cost = tried;
    states.swap(tried_);
    return share;
  }
  return 0.0;
}

template <class Motion>
void GaussNewton<Motion>::move(const States& from, double share, States& to) const {
  to = from;
  for (std::size_t i = 0; i < problem_.pose.size(); ++i) {
    const typename Motion::Vector v =
        share * step_.segment<Motion::kSize>(static_cast<Eigen::Index>(i) * Motion::kSize);
    typename Motion::State& state = to[problem_.pose[i]];
    state = Motion::moved(state, v);
  }
}

template bool are_turned_alike(const Problem<PlanarMotion>&,
                               const std::vector<PlanarMotion::State>&,
                               const std::vector<PlanarMotion::State>&);
template bool are_turned_alike(const Problem<SpatialMotion>&,
                               const std::vector<SpatialMotion::State>&,
                               const std::vector<SpatialMotion::State>&);
template class GaussNewton<PlanarMotion>;
template class GaussNewton<SpatialMotion>;

}  // namespace portolan
