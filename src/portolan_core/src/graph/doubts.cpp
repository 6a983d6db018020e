// SPDX-License-Identifier: BSD-3-Clause
#include "graph/doubts.hpp"

#include <cmath>

namespace portolan {

namespace {

constexpr double kSigmas = 5.0;  // of chi^2, for graphs of few loops

// By accepted arc: the heading left over, from its beginning to its end.
std::vector<double> turns_left(const Problem<PlanarMotion>& problem,
                               const std::vector<PlanarMotion::State>& states) {
  std::vector<double> turns;
  turns.reserve(problem.terms.size());
  for (const auto& term : problem.terms) {
    turns.push_back(PlanarMotion::residual(states[term.from], states[term.to], term.measured)[2]);
  }
  return turns;
}

}  // namespace

// Along the tree the turns add up from the root; each other arc closes a loop, round which they
// are what its arcs miss in closing, and that is below half a turn unless it was wound up.
template <>
bool is_wound_up<PlanarMotion>(const Problem<PlanarMotion>& problem, const SpanningTree& tree,
                               const std::vector<PlanarMotion::State>& states) {
  const std::vector<double> turns = turns_left(problem, states);
  std::vector<std::size_t> term_of(tree.arc_to.size(), SpanningTree::kNone);
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    for (const std::size_t end : {problem.terms[i].from, problem.terms[i].to}) {
      if (tree.arc_to[end] == problem.arc[i]) term_of[end] = i;
    }
  }
  std::vector<double> sum(tree.arc_to.size(), 0.0);
  for (const std::size_t pose : tree.order) {
    if (term_of[pose] == SpanningTree::kNone) continue;
    const bool forward = problem.terms[term_of[pose]].to == pose;
    sum[pose] = sum[tree.parent[pose]] + (forward ? 1.0 : -1.0) * turns[term_of[pose]];
  }
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    const auto& term = problem.terms[i];
    if (std::abs(turns[i]) > M_PI_2) return true;
    if (tree.component[term.from] != tree.component[term.to]) continue;
    if (std::abs(sum[term.from] + turns[i] - sum[term.to]) > M_PI) return true;
  }
  return false;
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
