// SPDX-License-Identifier: BSD-3-Clause
#include "graph/turn_average.hpp"

#include <algorithm>
#include <array>

#include "graph/block_cholesky.hpp"

namespace portolan {

namespace {

constexpr int kMostSteps = 10;
constexpr double kSmall = 1e-2;  // turn of a last step [rad]

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Sum of the weights of arcs, signed as in a graph's Laplacian: all axes and steps share it.
template <class Motion>
BlockMatrix<1> laplacian(const Problem<Motion>& problem) {
  BlockMatrix<1> H(problem.pose.size(), problem.pairs);
  for (const auto& term : problem.terms) {
    const double weight = Motion::turn_weight(term.information);
    for (const std::size_t end : {term.from, term.to}) {
      if (problem.node[end] >= 0) H.diagonal[at(problem.node[end])](0) += weight;
    }
    if (term.pair >= 0) H.beside[at(term.pair)](0) -= weight;
  }
  return H;
}

// By axis of the map: what pulls each node to turn about it.
template <class Motion>
std::array<Eigen::VectorXd, Motion::kTurns> pulls(
    const Problem<Motion>& problem, const std::vector<typename Motion::State>& states) {
  std::array<Eigen::VectorXd, Motion::kTurns> pull;
  pull.fill(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.pose.size())));
  for (const auto& term : problem.terms) {
    const auto left = Motion::turn_left(states[term.from], states[term.to], term.measured);
    const double weight = Motion::turn_weight(term.information);
    for (int axis = 0; axis < Motion::kTurns; ++axis) {
      const int from = problem.node[term.from];
      const int to = problem.node[term.to];
      if (from >= 0) pull[at(axis)][from] += weight * left[axis];
      if (to >= 0) pull[at(axis)][to] -= weight * left[axis];
    }
  }
  return pull;
}

}  // namespace

template <class Motion>
bool average_turns(const Problem<Motion>& problem, const BlockPattern& pattern,
                   std::vector<typename Motion::State>& states) {
  const BlockMatrix<1> H = laplacian(problem);
  BlockCholesky<1> cholesky(pattern, H);
  if (!cholesky.factor(H)) return false;
  double largest = 2.0 * kSmall;
  for (int i = 0; i < kMostSteps && largest > kSmall; ++i) {
    auto turns = pulls(problem, states);
    for (Eigen::VectorXd& turn : turns) cholesky.solve(turn);
    largest = 0.0;
    for (std::size_t node = 0; node < problem.pose.size(); ++node) {
      typename Motion::TurnVector turn;
      for (int axis = 0; axis < Motion::kTurns; ++axis) {
        turn[axis] = turns[at(axis)][static_cast<Eigen::Index>(node)];
      }
      auto& state = states[problem.pose[node]];
      state = Motion::turned_on(state, turn);
      largest = std::max(largest, turn.norm());
    }
  }
  return true;
}

template bool average_turns(const Problem<PlanarMotion>&, const BlockPattern&,
                            std::vector<PlanarMotion::State>&);
template bool average_turns(const Problem<SpatialMotion>&, const BlockPattern&,
                            std::vector<SpatialMotion::State>&);

}  // namespace portolan
