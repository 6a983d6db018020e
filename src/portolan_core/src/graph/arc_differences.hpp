// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "graph/block_cholesky.hpp"
#include "graph/problem.hpp"

namespace portolan {

/// Linear least squares for numbers x at the poses of a graph, zero at those that are fixed, of
/// which arcs know the differences: the sum of weight (x_to - x_from - difference)^2. Its matrix, a
/// weighted Laplacian, is factored once.
template <class Motion>
class ArcDifferences {
 public:
  /// Weights are by term. Problem and pattern must outlive it.
  ArcDifferences(const Problem<Motion>& problem, const BlockPattern& pattern,
                 std::vector<double> weights)
      : problem_(problem), weights_(std::move(weights)), cholesky_(pattern, problem.pairs) {
    BlockMatrix<1> H(problem.pose.size(), problem.pairs);
    for (std::size_t i = 0; i < problem.terms.size(); ++i) {
      const auto& term = problem.terms[i];
      for (const std::size_t end : {term.from, term.to}) {
        if (problem.node[end] >= 0) H.diagonal[at(problem.node[end])](0) += weights_[i];
      }
      if (term.pair >= 0) H.beside[at(term.pair)](0) -= weights_[i];
    }
    is_determined_ = cholesky_.factor(H);
  }

  /// False where arcs leave something open; then there is nothing to solve.
  bool is_determined() const { return is_determined_; }

  /// By term.
  const std::vector<double>& weights() const { return weights_; }
  /// By node, a column for each entry of what `difference(index of term)` returns.
  template <class Difference>
  auto solve(const Difference& difference) const {
    constexpr int kColumns = decltype(difference(std::size_t{}))::RowsAtCompileTime;
    using Row = Eigen::Matrix<double, 1, kColumns>;
    Eigen::Matrix<double, Eigen::Dynamic, kColumns> x;
    x.setZero(static_cast<Eigen::Index>(problem_.pose.size()), kColumns);
    for (std::size_t i = 0; i < problem_.terms.size(); ++i) {
      const Row pull = weights_[i] * difference(i).transpose();
      const int from = problem_.node[problem_.terms[i].from];
      const int to = problem_.node[problem_.terms[i].to];
      if (from >= 0) x.row(from) -= pull;
      if (to >= 0) x.row(to) += pull;
    }
    for (int j = 0; j < kColumns; ++j) cholesky_.solve(x.col(j));
    return x;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const Problem<Motion>& problem_;
  std::vector<double> weights_;
  BlockCholesky<1> cholesky_;
  bool is_determined_ = false;
};

}  // namespace portolan
