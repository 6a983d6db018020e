// SPDX-License-Identifier: BSD-3-Clause
#include "graph/rotation_start.hpp"

#include <array>

#include "graph/block_cholesky.hpp"

namespace portolan {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Least squares for n x columns unknowns X at each pose: sum of weight |X_to - Z^T X_from - b|^2.
template <int n, int columns>
class LinearLeastSquares {
 public:
  using Block = Eigen::Matrix<double, n, n>;
  using Unknown = Eigen::Matrix<double, n, columns>;

  template <class Motion>
  explicit LinearLeastSquares(const Problem<Motion>& problem)
      : H_(problem.pose.size(), problem.pairs) {
    right_.fill(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.pose.size()) * n));
  }

  // `fixed(pose)` is X of a pose that is not free.
  template <class Term, class Fixed>
  void add(const Term& term, const std::vector<int>& node, double weight, const Block& Z,
           const Unknown& b, const Fixed& fixed) {
    const int from = node[term.from];
    const int to = node[term.to];
    if (from >= 0) H_.diagonal[at(from)].diagonal().array() += weight;
    if (to >= 0) H_.diagonal[at(to)].diagonal().array() += weight;
    if (term.pair >= 0) {
      H_.beside[at(term.pair)] -= weight * (term.swapped ? Block(Z.transpose()) : Z);
    }
    if (to >= 0) pull(to, weight * (from < 0 ? b + Z.transpose() * fixed(term.from) : b));
    if (from >= 0) pull(from, weight * (Z * (to < 0 ? fixed(term.to) - b : Unknown(-b))));
  }

  bool solve(const BlockPattern& pattern) {
    BlockCholesky<n> cholesky(pattern, H_);
    if (!cholesky.factor(H_)) return false;
    for (Eigen::VectorXd& x : right_) cholesky.solve(x);
    return true;
  }

  Unknown at_node(int node) const {
    Unknown x;
    for (int j = 0; j < columns; ++j) x.col(j) = right_[at(j)].template segment<n>(node * n);
    return x;
  }

 private:
  void pull(int node, const Unknown& b) {
    for (int j = 0; j < columns; ++j) right_[at(j)].template segment<n>(node * n) += b.col(j);
  }

  BlockMatrix<n> H_;
  std::array<Eigen::VectorXd, columns> right_;
};

// X = R^T: R_to = R_from Z.
template <class Motion>
bool orient(const Problem<Motion>& problem, const BlockPattern& pattern,
            std::vector<typename Motion::State>& states) {
  using Turns = LinearLeastSquares<Motion::kSpace, Motion::kTurnColumns>;
  using Unknown = typename Turns::Unknown;
  Turns turns(problem);
  const auto fixed = [&](std::size_t pose) -> Unknown {
    return Motion::turn(states[pose]).transpose().template leftCols<Motion::kTurnColumns>();
  };
  for (const auto& term : problem.terms) {
    turns.add(term, problem.node, Motion::turn_weight(term.information),
              Motion::turn(term.measured), Unknown(Unknown::Zero()), fixed);
  }
  if (!turns.solve(pattern)) return false;
  for (std::size_t i = 0; i < problem.pose.size(); ++i) {
    auto& state = states[problem.pose[i]];
    state = Motion::with_turn(state, turns.at_node(static_cast<int>(i)));
  }
  return true;
}

// t_to = t_from + R_from t_measured.
template <class Motion>
bool put_in_place(const Problem<Motion>& problem, const BlockPattern& pattern,
                  std::vector<typename Motion::State>& states) {
  using Positions = LinearLeastSquares<1, Motion::kSpace>;
  Positions positions(problem);
  const auto fixed = [&](std::size_t pose) ->
      typename Positions::Unknown { return states[pose].t.transpose(); };
  const typename Positions::Block one = Positions::Block::Identity();
  for (const auto& term : problem.terms) {
    const typename Motion::Point step = Motion::turn(states[term.from]) * term.measured.t;
    positions.add(term, problem.node, Motion::point_weight(term.information), one,
                  typename Positions::Unknown(step.transpose()), fixed);
  }
  if (!positions.solve(pattern)) return false;
  for (std::size_t i = 0; i < problem.pose.size(); ++i) {
    states[problem.pose[i]].t = positions.at_node(static_cast<int>(i)).transpose();
  }
  return true;
}

}  // namespace

template <class Motion>
std::optional<std::vector<typename Motion::State>> rotation_start(
    const Problem<Motion>& problem, const BlockPattern& pattern,
    std::vector<typename Motion::State> states) {
  if (!orient(problem, pattern, states)) return std::nullopt;
  if (!put_in_place(problem, pattern, states)) return std::nullopt;
  return states;
}

template std::optional<std::vector<PlanarMotion::State>> rotation_start(
    const Problem<PlanarMotion>&, const BlockPattern&, std::vector<PlanarMotion::State>);
template std::optional<std::vector<SpatialMotion::State>> rotation_start(
    const Problem<SpatialMotion>&, const BlockPattern&, std::vector<SpatialMotion::State>);

}  // namespace portolan
