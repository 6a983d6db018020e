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
constexpr int kStepsToNear = 2;           // full ones, after which the minimum is near
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
typename GaussNewton<Motion>::Descent GaussNewton<Motion>::descend(States& states, double cost,
                                                                   const Kernel& kernel,
                                                                   const Limits& limits) {
  Descent descent;
  damping_ = 0.0;
  last_promise_ = 0.0;
  full_steps_ = 0;
  may_overshoot_ = true;
  descent.cost = cost;
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
  const auto enough = [&] {
    return limits.tolerance * descent.cost + kNoCost * static_cast<double>(problem_.terms.size());
  };
  if (is_near(descent) && improve_with_kept_factor(states, kernel, enough(), descent)) return true;
  equations_.linearize(problem_, states, kernel);
  while (damping_ <= kMostDamping) {
    if (!solve(descent)) {
      damp();
      continue;
    }
    // What the step promises, g^T H^-1 g, is all that is left to win near the minimum.
    const double promise = this->promise();
    const bool undamped = damping_ == 0.0 || descent.smallest_pivot == 0.0;
    const bool is_last = undamped && left_after(promise, descent) <= enough();
    const bool is_small = undamped && promise <= enough();
    if (moves(1.0, states, kernel, descent)) {
      descent.converged = is_last;
    } else if (!overshoots(states, kernel, descent) && !moves_some(states, kernel, descent)) {
      descent.converged = is_small;
      if (descent.converged) return true;
      damp();
      continue;
    } else {
      descent.converged = is_small;
      full_steps_ = 0;
    }
    damping_ = damping_ > kLeastDamping ? 0.1 * damping_ : 0.0;
    if (damping_ < kLeastDamping) damping_ = 0.0;
    return true;
  }
  return false;
}

// Whether the factor of the last step may be good enough for the next one.
template <class Motion>
bool GaussNewton<Motion>::is_near(const Descent& descent) const {
  if (damping_ > 0.0 || last_promise_ <= 0.0) return false;
  return full_steps_ >= kStepsToNear || last_promise_ <= kNear * descent.cost;
}

// A step that needs no more than the gradient: near the minimum the factor hardly changes.
template <class Motion>
bool GaussNewton<Motion>::improve_with_kept_factor(States& states, const Kernel& kernel,
                                                   double enough, Descent& descent) {
  equations_.add_up_gradient(problem_, states, kernel);
  if (!solve_with_factor()) return false;
  const double promise = this->promise();
  if (promise > std::max(kFast * last_promise_, kLittle * descent.cost)) return false;
  const double before = descent.cost;
  if (moves(1.0, states, kernel, descent)) {
    // It leaves no more than it won less, or more, than it promised.
    descent.converged = std::abs(promise - (before - descent.cost)) <= enough;
    last_promise_ = promise;
    return true;
  }
  descent.converged = promise <= enough;
  last_promise_ = 0.0;
  return descent.converged;
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

template <class Motion>
bool GaussNewton<Motion>::solve(Descent& descent) {
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

// Moves by a share of the step if that improves the cost.
template <class Motion>
bool GaussNewton<Motion>::moves(double share, States& states, const Kernel& kernel,
                                Descent& descent) {
  move(states, share, tried_);
  const double tried = cost(problem_, tried_, kernel);
  if (!(tried < descent.cost)) return false;
  descent.cost = tried;
  states.swap(tried_);
  if (share == 1.0) ++full_steps_;
  return true;
}

template <class Motion>
bool GaussNewton<Motion>::moves_some(States& states, const Kernel& kernel, Descent& descent) {
  for (double share = 0.5; share >= kShortestStep; share *= 0.5) {
    if (moves(share, states, kernel, descent)) return true;
  }
  return false;
}

// A step along a narrow valley that bends ends up its side, and the next one at its bottom again,
// far ahead: so that both together are tried, as long as that helps.
template <class Motion>
bool GaussNewton<Motion>::overshoots(States& states, const Kernel& kernel, Descent& descent) {
  if (damping_ > 0.0 || !may_overshoot_) return false;
  const Eigen::VectorXd first = step_;
  States beyond = tried_;
  equations_.linearize(problem_, beyond, kernel);
  may_overshoot_ = solve(descent);
  if (may_overshoot_) {
    move(beyond, 1.0, tried_);
    const double tried = cost(problem_, tried_, kernel);
    may_overshoot_ = tried < descent.cost;
    if (may_overshoot_) {
      descent.cost = tried;
      states.swap(tried_);
      last_promise_ = 0.0;
      ++descent.iterations;
      return true;
    }
  }
  step_ = first;
  equations_.linearize(problem_, states, kernel);
  return false;
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
