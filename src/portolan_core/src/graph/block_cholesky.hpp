// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "graph/block_matrix.hpp"
#include "graph/block_pattern.hpp"

namespace portolan {

/// Cholesky factor of a symmetric matrix of n x n blocks, each supernode a dense matrix: the
/// multifrontal method. What the elimination of a supernode changes in the rest of the matrix
/// waits on a stack until its parent takes it over.
template <int n>
class BlockCholesky {
 public:
  /// Of matrices with the same pairs as this one; the pattern must outlive it.
  BlockCholesky(const BlockPattern& pattern, const BlockMatrix<n>& matrix);

  /// Factors the matrix with its diagonal times 1 + damping. False where that is not positive
  /// definite; then there is nothing to solve with.
  bool factor(const BlockMatrix<n>& matrix, double damping = 0.0);
  /// The smallest pivot relative to what stood in its place before elimination: near rounding
  /// where the matrix is nearly singular.
  double smallest_pivot() const { return smallest_pivot_; }
  /// x = A^-1 x, by node.
  void solve(Eigen::VectorXd& x) const;

  const BlockPattern& pattern() const { return *pattern_; }
  /// Lower trapezoid of a supernode, column-major: its columns of the factor.
  const double* panel(std::size_t supernode) const { return values_.data() + begin_[supernode]; }
  /// From one column to the next.
  std::ptrdiff_t leading_dimension(std::size_t supernode) const;

 private:
  struct Update {
    std::size_t supernode;
    std::size_t begin;  // in stack_
  };

  void copy(const BlockMatrix<n>& matrix, double damping);
  double* place_update(std::size_t supernode);
  void take_over(const Update& child, std::size_t supernode, double* update);
  void find_smallest_pivot(const BlockMatrix<n>& matrix, double damping);

  void solve_forward(std::size_t s, Eigen::VectorXd& dense, Eigen::VectorXd& x) const;
  void solve_backward(std::size_t s, Eigen::VectorXd& dense, Eigen::VectorXd& x) const;

  const BlockPattern* pattern_;
  std::vector<std::size_t> begin_;      // by supernode: its panel in values_
  std::vector<std::size_t> diagonal_;   // by node: its block in values_
  std::vector<std::ptrdiff_t> beside_;  // by pair: its block in values_; ~ of it if transposed
  std::vector<std::ptrdiff_t> step_;    // by pair: leading dimension there
  std::vector<int> children_;           // by supernode: how many
  std::vector<double> values_;
  std::vector<double> stack_;
  std::vector<Update> waiting_;  // updates on the stack
  double smallest_pivot_ = 0.0;
};

}  // namespace portolan
