// SPDX-License-Identifier: BSD-3-Clause
#include "graph/normal_equations.hpp"

namespace portolan {

template <class Motion>
double NormalEquations<Motion>::linearize(const Problem<Motion>& problem,
                                          const std::vector<typename Motion::State>& states,
                                          const Kernel& kernel) {
  constexpr int kSize = Motion::kSize;
  using Matrix = typename Motion::Matrix;
  double total = 0.0;
  H.set_zero();
  g.setZero();
  for (const auto& term : problem.terms) {
    const auto l = Motion::linearize(states[term.from], states[term.to], term.measured);
    const typename Motion::Vector w_r = term.information * l.r;
    const double r2 = l.r.dot(w_r);
    total += term.may_fail ? kernel.cost(r2) : r2;
    const double weight = term.may_fail ? kernel.weight(r2) : 1.0;
    const int from = problem.node[term.from];
    const int to = problem.node[term.to];
    const Matrix w_from = weight * (term.information * l.H_from);
    const Matrix w_to = weight * (term.information * l.H_to);
    if (from >= 0) {
      H.diagonal[static_cast<std::size_t>(from)].noalias() += l.H_from.transpose() * w_from;
      g.template segment<kSize>(from * kSize).noalias() += weight * (l.H_from.transpose() * w_r);
    }
    if (to >= 0) {
      H.diagonal[static_cast<std::size_t>(to)].noalias() += l.H_to.transpose() * w_to;
      g.template segment<kSize>(to * kSize).noalias() += weight * (l.H_to.transpose() * w_r);
    }
    if (term.pair < 0) continue;
    auto& beside = H.beside[static_cast<std::size_t>(term.pair)];
    if (term.swapped) {
      beside.noalias() += l.H_to.transpose() * w_from;
    } else {
      beside.noalias() += l.H_from.transpose() * w_to;
    }
  }
  return total;
}

template <class Motion>
double cost(const Problem<Motion>& problem, const std::vector<typename Motion::State>& states,
            const Kernel& kernel) {
  double total = 0.0;
  for (const auto& term : problem.terms) {
    const auto r = Motion::residual(states[term.from], states[term.to], term.measured);
    const double r2 = r.dot(term.information * r);
    total += term.may_fail ? kernel.cost(r2) : r2;
  }
  return total;
}

template struct NormalEquations<PlanarMotion>;
template struct NormalEquations<SpatialMotion>;
template double cost<PlanarMotion>(const Problem<PlanarMotion>&,
                                   const std::vector<PlanarMotion::State>&, const Kernel&);
template double cost<SpatialMotion>(const Problem<SpatialMotion>&,
                                    const std::vector<SpatialMotion::State>&, const Kernel&);

}  // namespace portolan
