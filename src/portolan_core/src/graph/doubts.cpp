// SPDX-License-Identifier: BSD-3-Clause
#include "graph/doubts.hpp"

#include <algorithm>
#include <cmath>

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

bool is_disconnected(const Graph& graph, const SpanningTree& tree) {
  const auto& poses = graph.poses();
  const auto fixed = static_cast<std::size_t>(
      std::count_if(poses.begin(), poses.end(), [](const GraphPose& p) { return p.fixed; }));
  return tree.components > std::max<std::size_t>(fixed, 1);
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
