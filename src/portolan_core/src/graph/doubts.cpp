// SPDX-License-Identifier: BSD-3-Clause
#include "graph/doubts.hpp"

#include <algorithm>
#include <cmath>

#include "graph/winding.hpp"

namespace portolan {

namespace {

constexpr double kSigmas = 5.0;  // of chi^2, for graphs of few loops

}  // namespace

template <class Motion>
bool is_turned_beyond(double angle, const Problem<Motion>& problem,
                      const std::vector<typename Motion::State>& states) {
  return std::any_of(problem.terms.begin(), problem.terms.end(), [&](const auto& term) {
    return Motion::angle_left(states[term.from], states[term.to], term.measured) > angle;
  });
}

template <>
bool is_wound_up<PlanarMotion>(const Problem<PlanarMotion>& problem, const SpanningTree& tree,
                               const std::vector<PlanarMotion::State>& states) {
  if (is_turned_beyond(M_PI_2, problem, states)) return true;
  const std::vector<double> left = turns_round_loops(problem, tree, states);
  return std::any_of(left.begin(), left.end(), [](double turn) { return std::abs(turn) > M_PI; });
}

template <>
bool is_wound_up<SpatialMotion>(const Problem<SpatialMotion>& problem, const SpanningTree&,
                                const std::vector<SpatialMotion::State>& states) {
  return is_turned_beyond(M_PI_2, problem, states);
}

bool is_poor_fit(double chi2, std::size_t degrees_of_freedom, double factor) {
  const auto degrees = static_cast<double>(degrees_of_freedom);
  return chi2 > factor * degrees + kSigmas * std::sqrt(2.0 * degrees) + 1e-6;
}

template bool is_turned_beyond(double, const Problem<PlanarMotion>&,
                               const std::vector<PlanarMotion::State>&);
template bool is_turned_beyond(double, const Problem<SpatialMotion>&,
                               const std::vector<SpatialMotion::State>&);

}  // namespace portolan
