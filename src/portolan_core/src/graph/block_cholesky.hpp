// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "graph/aligned_room.hpp"
#include "graph/block_matrix.hpp"
#include "graph/block_pattern.hpp"

namespace portolan {

/// Cholesky factor of a symmetric matrix of n x n blocks, each supernode a dense matrix. What the
/// elimination of a supernode changes in the rest of the matrix is worked out in one piece and
/// handed out at once to the supernodes above, whose columns it belongs to.
template <int n>
class BlockCholesky {
 public:
  /// Of matrices with entries for these pairs; the pattern must outlive it.
  BlockCholesky(const BlockPattern& pattern, const std::vector<std::pair<int, int>>& pairs);

  /// Factors the matrix with its diagonal times 1 + damping. False where that is not positive
  /// definite; then there is nothing to solve with.
  bool factor(const BlockMatrix<n>& matrix, double damping = 0.0);
  /// The smallest pivot relative to what stood in its place before elimination: near rounding
  /// where the matrix is nearly singular.
  double smallest_pivot() const { return smallest_pivot_; }
  /// x = A^-1 x, by node.
  void solve(Eigen::Ref<Eigen::VectorXd> x) const;

  const BlockPattern& pattern() const { return *pattern_; }
  /// Lower trapezoid of a supernode, column-major: its columns of the factor, with the inverses of
  /// what stands on the diagonal instead.
  const double* panel(std::size_t supernode) const { return values_.get() + begin_[supernode]; }
  /// From one column to the next.
  std::ptrdiff_t leading_dimension(std::size_t supernode) const;

 private:
  struct Run {
    int first;
    int last;  // behind it
  };

  void copy(const BlockMatrix<n>& matrix, double damping);
  std::size_t find_runs(const int* rows, int size);
  void hand_out(std::size_t supernode);
  void find_smallest_pivot(const BlockMatrix<n>& matrix, double damping);

  void solve_forward(std::size_t s, double* dense, Eigen::VectorXd& x) const;
  void solve_backward(std::size_t s, double* dense, Eigen::VectorXd& x) const;

  const BlockPattern* pattern_;
  std::vector<std::size_t> begin_;      // by supernode: its panel in values_
  std::vector<std::size_t> diagonal_;   // by node: its block in values_
  std::vector<std::ptrdiff_t> beside_;  // by pair: its block in values_; ~ of it if transposed
  std::vector<std::ptrdiff_t> step_;    // by pair: leading dimension there
  std::size_t size_ = 0;                // of values_
  std::ptrdiff_t highest_ = 0;          // panel
  AlignedRoom values_;
  std::vector<Run> runs_;
  AlignedRoom update_;  // what a supernode changes in those above
  double smallest_pivot_ = 0.0;
};

}  // namespace portolan
