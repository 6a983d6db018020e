// SPDX-License-Identifier: BSD-3-Clause
#include "graph/winding.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "graph/linear_least_squares.hpp"
#include "graph/rotation_start.hpp"

namespace portolan {

namespace {

using States = std::vector<PlanarMotion::State>;
using Term = Problem<PlanarMotion>::Term;

constexpr double kUnknown = 1e12;  // variance of a turn of which an arc says nothing

double turn_left(const Term& term, const States& states) {
  return PlanarMotion::residual(states[term.from], states[term.to], term.measured)[2];
}

// By pose: the term of the tree's arc that leads to it; `kNone` for roots.
std::vector<std::size_t> terms_of_tree(const Problem<PlanarMotion>& problem,
                                       const SpanningTree& tree) {
  std::vector<std::size_t> term_to(tree.arc_to.size(), SpanningTree::kNone);
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    for (const std::size_t end : {problem.terms[i].from, problem.terms[i].to}) {
      if (tree.arc_to[end] == problem.arc[i]) term_to[end] = i;
    }
  }
  return term_to;
}

// By pose: what `of(term, forward)` adds up to along the tree, from the root.
template <class Of>
std::vector<double> added_up(const SpanningTree& tree, const Problem<PlanarMotion>& problem,
                             const std::vector<std::size_t>& term_to, const Of& of) {
  std::vector<double> sum(tree.arc_to.size(), 0.0);
  for (const std::size_t pose : tree.order) {
    if (term_to[pose] == SpanningTree::kNone) continue;
    const Term& term = problem.terms[term_to[pose]];
    sum[pose] = sum[tree.parent[pose]] + of(term, term.to == pose);
  }
  return sum;
}

// The last entry of the inverse, or of the pseudoinverse where the arc leaves a direction open: to
// turn along with what is open, the pose would have to move on and on.
double variance_of_turn(const Term& term) {
  const Eigen::Matrix3d& m = term.information;
  const double position = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  const double left = m.determinant();
  constexpr double kSingular = 1e-9;
  if (left > kSingular * m(0, 0) * m(1, 1) * m(2, 2)) return position / left;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions(m);
  double variance = m(2, 2) > 0.0 ? 0.0 : kUnknown;
  for (int k = 0; k < 3; ++k) {
    const double known = directions.eigenvalues()[k];
    const double turn = directions.eigenvectors()(2, k);
    if (known > kSingular * directions.eigenvalues()[2]) variance += turn * turn / known;
  }
  return variance;
}

// The way up the tree to where two poses' ways from the root part.
std::size_t meeting(const SpanningTree& tree, const std::vector<std::size_t>& depth, std::size_t a,
                    std::size_t b) {
  while (a != b) {
    std::size_t& lower = depth[a] > depth[b] ? a : b;
    lower = tree.parent[lower];
  }
  return a;
}

// By term that closes a loop: the variance of the turns round it.
std::vector<double> variances_round_loops(const Problem<PlanarMotion>& problem,
                                          const SpanningTree& tree) {
  const std::vector<std::size_t> term_to = terms_of_tree(problem, tree);
  const std::vector<double> variance = added_up(
      tree, problem, term_to, [](const Term& term, bool) { return variance_of_turn(term); });
  std::vector<std::size_t> depth(tree.arc_to.size(), 0);
  for (const std::size_t pose : tree.order) {
    if (tree.parent[pose] != SpanningTree::kNone) depth[pose] = depth[tree.parent[pose]] + 1;
  }
  std::vector<double> round(problem.terms.size(), 0.0);
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    const Term& term = problem.terms[i];
    if (tree.component[term.from] != tree.component[term.to]) continue;
    const std::size_t fork = meeting(tree, depth, term.from, term.to);
    round[i] =
        variance[term.from] + variance[term.to] - 2.0 * variance[fork] + variance_of_turn(term);
  }
  return round;
}

}  // namespace

std::vector<double> turns_round_loops(const Problem<PlanarMotion>& problem,
                                      const SpanningTree& tree, const States& states) {
  const std::vector<std::size_t> term_to = terms_of_tree(problem, tree);
  const std::vector<double> sum =
      added_up(tree, problem, term_to, [&](const Term& term, bool forward) {
        return forward ? turn_left(term, states) : -turn_left(term, states);
      });
  std::vector<double> round(problem.terms.size(), 0.0);
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    const Term& term = problem.terms[i];
    if (term_to[term.to] == i || term_to[term.from] == i) continue;
    if (tree.component[term.from] != tree.component[term.to]) continue;
    round[i] = sum[term.from] + turn_left(term, states) - sum[term.to];
  }
  return round;
}

std::vector<OtherWinding> other_windings(const Problem<PlanarMotion>& problem,
                                         const SpanningTree& tree, const States& states,
                                         double highest_price) {
  const std::vector<double> round = turns_round_loops(problem, tree, states);
  const std::vector<double> variance = variances_round_loops(problem, tree);
  std::vector<OtherWinding> others;
  for (std::size_t i = 0; i < round.size(); ++i) {
    if (round[i] == 0.0 || variance[i] <= 0.0) continue;
    const double whole = std::copysign(2.0 * M_PI, round[i]);
    const double other = round[i] - whole;
    const double price = (other * other - round[i] * round[i]) / variance[i];
    if (price > highest_price) continue;
    others.push_back({i, turn_left(problem.terms[i], states) - whole, price});
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const OtherWinding& a, const OtherWinding& b) { return a.price < b.price; });
  return others;
}

std::optional<States> rewound(const Problem<PlanarMotion>& problem, const BlockPattern& pattern,
                              States states, const OtherWinding& winding) {
  using Turns = LinearLeastSquares<1, 1>;
  using Number = Turns::Unknown;
  Turns turns(problem);
  const auto stays = [](std::size_t) { return Number(Number::Zero()); };
  const Number one = Number::Ones();
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    const Term& term = problem.terms[i];
    const double left = i == winding.term ? winding.turn : turn_left(term, states);
    turns.add(term, problem.node, PlanarMotion::turn_weight(term.information), one,
              Number(Number::Constant(-left)), stays);
  }
  if (!turns.solve(pattern)) return std::nullopt;
  for (std::size_t i = 0; i < problem.pose.size(); ++i) {
    PlanarMotion::State& state = states[problem.pose[i]];
    const double turn = turns.at_node(static_cast<int>(i))(0);
    state = PlanarMotion::turned(state.t, wrap_angle(state.heading + turn));
  }
  if (!put_in_place(problem, pattern, states)) return std::nullopt;
  return states;
}

std::vector<OtherWinding> other_windings(const Problem<SpatialMotion>&, const SpanningTree&,
                                         const std::vector<SpatialMotion::State>&, double) {
  return {};
}

std::optional<std::vector<SpatialMotion::State>> rewound(const Problem<SpatialMotion>&,
                                                         const BlockPattern&,
                                                         const std::vector<SpatialMotion::State>&,
                                                         const OtherWinding&) {
  return std::nullopt;
}

}  // namespace portolan
