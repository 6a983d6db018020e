// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "graph/block_cholesky.hpp"

namespace portolan {

/// Least squares for n x columns unknowns X at each pose of a graph: the sum over its arcs of
/// weight |X_to - Z^T X_from - b|^2, for rotations Z.
template <int n, int columns>
class LinearLeastSquares {
 public:
  using Block = Eigen::Matrix<double, n, n>;
  using Unknown = Eigen::Matrix<double, n, columns>;

  /// Of a `Problem`.
  template <class Problem>
  explicit LinearLeastSquares(const Problem& problem) : H_(problem.pose.size(), problem.pairs) {
    right_.fill(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.pose.size()) * n));
  }

  /// An arc. `fixed(pose)` is X of a pose that is not free.
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

  /// False where arcs leave something open.
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
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void pull(int node, const Unknown& b) {
    for (int j = 0; j < columns; ++j) right_[at(j)].template segment<n>(node * n) += b.col(j);
  }

  BlockMatrix<n> H_;
  std::array<Eigen::VectorXd, columns> right_;
};

}  // namespace portolan
