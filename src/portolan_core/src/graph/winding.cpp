// SPDX-License-Identifier: BSD-3-Clause
#include "graph/winding.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

using Term = Problem<PlanarMotion>::Term;
using States = std::vector<PlanarMotion::State>;

constexpr double kUnknown = 1e12;  // variance of a turn of which an arc says nothing
constexpr double kWholeTurn = 2.0 * M_PI;

double turn_left(const Term& term, const States& states) {
  return PlanarMotion::turn_left(states[term.from], states[term.to], term.measured)[0];
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

double whole_turns(double turn) { return std::round(turn / kWholeTurn); }

}  // namespace

Loops<PlanarMotion>::Loops(const Problem<PlanarMotion>& problem, const SpanningTree& tree)
    : problem_(problem), tree_(tree), term_to_(terms_of_tree(problem, tree)) {
  for (std::size_t i = 0; i < problem.terms.size(); ++i) {
    const Term& term = problem.terms[i];
    if (term_to_[term.to] == i || term_to_[term.from] == i) continue;
    if (tree.component[term.from] == tree.component[term.to]) closing_.push_back(i);
  }
  find_variances();
}

void Loops<PlanarMotion>::find_variances() {
  const std::vector<double> variance = added_up(
      tree_, problem_, term_to_, [](const Term& term, bool) { return variance_of_turn(term); });
  std::vector<std::size_t> depth(tree_.arc_to.size(), 0);
  for (const std::size_t pose : tree_.order) {
    if (tree_.parent[pose] != SpanningTree::kNone) depth[pose] = depth[tree_.parent[pose]] + 1;
  }
  variance_.reserve(closing_.size());
  for (const std::size_t closing : closing_) {
    const Term& term = problem_.terms[closing];
    const std::size_t fork = meeting(tree_, depth, term.from, term.to);
    variance_.push_back(variance[term.from] + variance[term.to] - 2.0 * variance[fork] +
                        variance_of_turn(term));
  }
}

std::vector<double> Loops<PlanarMotion>::turns(const States& states) const {
  const std::vector<double> sum =
      added_up(tree_, problem_, term_to_, [&](const Term& term, bool forward) {
        return forward ? turn_left(term, states) : -turn_left(term, states);
      });
  std::vector<double> round;
  round.reserve(closing_.size());
  for (const std::size_t closing : closing_) {
    const Term& term = problem_.terms[closing];
    round.push_back(sum[term.from] + turn_left(term, states) - sum[term.to]);
  }
  return round;
}

std::vector<OtherWinding> Loops<PlanarMotion>::other_windings(const States& states,
                                                              const std::vector<double>& turns,
                                                              double highest_price) const {
  std::vector<OtherWinding> others;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (turns[i] == 0.0 || variance_[i] <= 0.0) continue;
    const double whole = std::copysign(kWholeTurn, turns[i]);
    const double other = turns[i] - whole;
    const double price = (other * other - turns[i] * turns[i]) / variance_[i];
    if (price > highest_price) continue;
    others.push_back({closing_[i], turn_left(problem_.terms[closing_[i]], states) - whole, price});
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const OtherWinding& a, const OtherWinding& b) { return a.price < b.price; });
  return others;
}

bool is_wound_up(const std::vector<double>& turns) {
  return std::any_of(turns.begin(), turns.end(), [](double turn) { return std::abs(turn) > M_PI; });
}

bool are_wound_alike(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return whole_turns(x) == whole_turns(y); });
}

}  // namespace portolan
