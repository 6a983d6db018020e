// SPDX-License-Identifier: BSD-3-Clause
#include "graph/normal_equations.hpp"

namespace portolan {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The information times the weight that the kernel leaves.
template <class Term, class Vector>
auto weighted(const Term& term, const Vector& r, const Kernel& kernel) {
  using Matrix = decltype(term.information);
  if (!term.may_fail || kernel.shape == RobustKernel::none) return term.information;
  return Matrix(kernel.weight(r.dot(term.information * r)) * term.information);
}

// J^T W r of both ends.
template <class Motion>
void pull(const Problem<Motion>& problem, const typename Problem<Motion>::Term& term,
          const typename Motion::Linearized& l, const typename Motion::Vector& w_r,
          Eigen::VectorXd& g) {
  constexpr Eigen::Index kSize = Motion::kSize;
  const int from = problem.node[term.from];
  const int to = problem.node[term.to];
  if (from >= 0) g.segment<kSize>(from * kSize).noalias() += l.H_from.transpose() * w_r;
  if (to >= 0) g.segment<kSize>(to * kSize).noalias() += l.H_to.transpose() * w_r;
}

}  // namespace

template <class Motion>
void NormalEquations<Motion>::linearize(const Problem<Motion>& problem,
                                        const std::vector<typename Motion::State>& states,
                                        const Kernel& kernel) {
  using Matrix = typename Motion::Matrix;
  H.set_zero();
  g.setZero();
  for (const auto& term : problem.terms) {
    const auto l = Motion::linearize(states[term.from], states[term.to], term.measured);
    const Matrix W = weighted(term, l.r, kernel);
    pull<Motion>(problem, term, l, W * l.r, g);
    const int from = problem.node[term.from];
    const int to = problem.node[term.to];
    const Matrix w_from = W * l.H_from;
    if (from >= 0) H.diagonal[at(from)].noalias() += l.H_from.transpose() * w_from;
    if (to >= 0) H.diagonal[at(to)].noalias() += l.H_to.transpose() * (W * l.H_to);
    if (term.pair < 0) continue;
    auto& beside = H.beside[at(term.pair)];
    if (term.swapped) {
      beside.noalias() += l.H_to.transpose() * w_from;
    } else {
      beside.noalias() += w_from.transpose() * l.H_to;
    }
  }
}

template <class Motion>
void NormalEquations<Motion>::add_up_gradient(const Problem<Motion>& problem,
                                              const std::vector<typename Motion::State>& states,
                                              const Kernel& kernel) {
  g.setZero();
  for (const auto& term : problem.terms) {
    const auto l = Motion::linearize(states[term.from], states[term.to], term.measured);
    pull<Motion>(problem, term, l, weighted(term, l.r, kernel) * l.r, g);
  }
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
