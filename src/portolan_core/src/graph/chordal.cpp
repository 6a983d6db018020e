// SPDX-License-Identifier: BSD-3-Clause
#include "graph/chordal.hpp"

#include <array>

#include "graph/block_cholesky.hpp"

namespace portolan {

namespace {

using Turn = SpatialMotion::Turn;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Of the sum over arcs of weight |X_to - Z^T X_from|^2 for X = R^T, since R_to = R_from Z.
struct Equations {
  explicit Equations(const Problem<SpatialMotion>& problem)
      : H(problem.pose.size(), problem.pairs) {
    right.fill(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(problem.pose.size())));
  }

  void pull(int node, const Turn& X) {
    for (int j = 0; j < 3; ++j) right[at(j)].segment<3>(node * Eigen::Index{3}) += X.col(j);
  }

  BlockMatrix<3> H;
  std::array<Eigen::VectorXd, 3> right;  // by column of X
};

Equations equations(const Problem<SpatialMotion>& problem,
                    const std::vector<SpatialMotion::State>& states) {
  Equations sum(problem);
  for (const auto& term : problem.terms) {
    const double weight = SpatialMotion::turn_weight(term.information);
    const Turn weighted = weight * term.measured.R;
    const int from = problem.node[term.from];
    const int to = problem.node[term.to];
    if (from >= 0) sum.H.diagonal[at(from)].diagonal().array() += weight;
    if (to >= 0) sum.H.diagonal[at(to)].diagonal().array() += weight;
    if (term.pair >= 0) {
      sum.H.beside[at(term.pair)] -= term.swapped ? Turn(weighted.transpose()) : weighted;
    } else if (to >= 0) {
      sum.pull(to, weighted.transpose() * states[term.from].R.transpose());
    } else if (from >= 0) {
      sum.pull(from, weighted * states[term.to].R.transpose());
    }
  }
  return sum;
}

}  // namespace

bool orient_by_matrices(const Problem<SpatialMotion>& problem, const BlockPattern& pattern,
                        std::vector<SpatialMotion::State>& states) {
  Equations sum = equations(problem, states);
  BlockCholesky<3> cholesky(pattern, problem.pairs);
  if (!cholesky.factor(sum.H)) return false;
  for (Eigen::VectorXd& x : sum.right) cholesky.solve(x);
  for (std::size_t node = 0; node < problem.pose.size(); ++node) {
    Turn X;
    for (int j = 0; j < 3; ++j) {
      X.col(j) = sum.right[at(j)].segment<3>(3 * static_cast<Eigen::Index>(node));
    }
    auto& state = states[problem.pose[node]];
    state = SpatialMotion::with_turn(state, X);
  }
  return true;
}

}  // namespace portolan
