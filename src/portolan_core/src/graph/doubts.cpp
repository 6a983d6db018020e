// SPDX-License-Identifier: BSD-3-Clause
#include "graph/doubts.hpp"

#include <algorithm>
#include <cmath>

#include "graph/winding.hpp"

namespace portolan {

namespace {

constexpr double kSigmas = 5.0;  // of chi^2, for graphs of few loops

}  // namespace

template <>
bool is_wound_up<PlanarMotion>(const Problem<PlanarMotion>& problem, const SpanningTree& tree,
                               const std::vector<PlanarMotion::State>& states) {
  for (const auto& term : problem.terms) {
    const auto r = PlanarMotion::residual(states[term.from], states[term.to], term.measured);
    if (std::abs(r[2]) > M_PI_2) return true;
  }
  const std::vector<double> left = turns_round_loops(problem, tree, states);
  return std::any_of(left.begin(), left.end(), [](double turn) { return std::abs(turn) > M_PI; });
}

template <>
bool is_wound_up<SpatialMotion>(const Problem<SpatialMotion>& problem, const SpanningTree&,
                                const std::vector<SpatialMotion::State>& states) {
  for (const auto& term : problem.terms) {
    const auto r = SpatialMotion::residual(states[term.from], states[term.to], term.measured);
    if (r.tail<3>().norm() > M_SQRT2) return true;  // 2 sin(45 deg)
  }
  return false;
}

bool is_poor_fit(double chi2, std::size_t degrees_of_freedom, double factor) {
  const auto degrees = static_cast<double>(degrees_of_freedom);
  return chi2 > factor * degrees + kSigmas * std::sqrt(2.0 * degrees) + 1e-6;
}

}  // namespace portolan
