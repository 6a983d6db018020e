// SPDX-License-Identifier: BSD-3-Clause
#include "graph/block_cholesky.hpp"

#include <algorithm>
#include <cstring>

#include "graph/dense_kernels.hpp"

namespace portolan {

namespace {

using Index = std::ptrdiff_t;
using Supernode = BlockPattern::Supernode;

std::size_t at(int i) { return static_cast<std::size_t>(i); }
std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <int n>
Index panel_step(const Supernode& supernode) {
  return DenseKernels::padded(supernode.height * Index{n});
}
template <int n>
std::size_t panel_size(const Supernode& supernode) {
  return at(panel_step<n>(supernode) * supernode.columns() * n);
}
template <int n>
Index update_step(const Supernode& supernode) {
  return DenseKernels::padded(supernode.rows_below() * Index{n});
}
template <int n>
std::size_t update_size(const Supernode& supernode) {
  return at(update_step<n>(supernode) * supernode.rows_below() * n);
}

// A column of blocks, of rows that stay neighbours.
template <int n>
void subtract(const double* from, Index from_step, int rows, double* to, Index to_step) {
  for (int j = 0; j < n; ++j, from += from_step, to += to_step) {
    for (Index i = 0; i < rows * Index{n}; ++i) to[i] -= from[i];
  }
}

template <int n>
void put(const typename BlockMatrix<n>::Block& block, double* to, Index step) {
  for (int j = 0; j < n; ++j) std::memcpy(to + j * step, block.col(j).data(), n * sizeof(double));
}

}  // namespace

template <int n>
BlockCholesky<n>::BlockCholesky(const BlockPattern& pattern,
                                const std::vector<std::pair<int, int>>& pairs)
    : pattern_(&pattern) {
  std::size_t largest = 0;
  int most_rows = 0;
  for (const Supernode& supernode : pattern.supernodes()) {
    begin_.push_back(size_);
    size_ += panel_size<n>(supernode);
    most_rows = std::max(most_rows, supernode.rows_below());
    largest = std::max(largest, update_size<n>(supernode));
    highest_ = std::max(highest_, panel_step<n>(supernode));
  }
  runs_.resize(at(most_rows));
  values_ = AlignedRoom(size_);
  update_ = AlignedRoom(largest);
  const auto find = [&](int row, int column) {
    const int s = pattern.supernode_of()[at(column)];
    const Supernode& supernode = pattern.supernodes()[at(s)];
    return begin_[at(s)] + at(pattern.row_in(supernode, row) * Index{n} +
                              (column - supernode.first) * n * panel_step<n>(supernode));
  };
  for (const int place : pattern.place()) diagonal_.push_back(find(place, place));
  for (const auto& [first, second] : pairs) {
    const int row = pattern.place()[at(first)];
    const int column = pattern.place()[at(second)];
    const Index place = static_cast<Index>(find(std::max(row, column), std::min(row, column)));
    beside_.push_back(row > column ? place : ~place);
    const int s = pattern.supernode_of()[at(std::min(row, column))];
    step_.push_back(panel_step<n>(pattern.supernodes()[at(s)]));
  }
}

template <int n>
std::ptrdiff_t BlockCholesky<n>::leading_dimension(std::size_t supernode) const {
  return panel_step<n>(pattern_->supernodes()[supernode]);
}

template <int n>
bool BlockCholesky<n>::factor(const BlockMatrix<n>& matrix, double damping) {
  copy(matrix, damping);
  const DenseKernels& kernels = dense_kernels();
  for (std::size_t s = 0; s < pattern_->supernodes().size(); ++s) {
    const Supernode& supernode = pattern_->supernodes()[s];
    const Index step = panel_step<n>(supernode);
    const Index columns = supernode.columns() * Index{n};
    double* panel = values_.get() + begin_[s];
    if (!kernels.factor_panel(panel, step, columns)) return false;
    if (supernode.rows_below() == 0) continue;
    kernels.square(update_.get(), update_step<n>(supernode), supernode.rows_below() * Index{n},
                   panel + columns, step, columns);
    hand_out(s);
  }
  find_smallest_pivot(matrix, damping);
  return true;
}

// How many runs of rows there are that stay neighbours.
template <int n>
std::size_t BlockCholesky<n>::find_runs(const int* rows, int size) {
  std::size_t count = 0;
  for (int row = 0; row < size; ++row) {
    if (row > 0 && rows[row] == rows[row - 1] + 1) {
      ++runs_[count - 1].last;
    } else {
      runs_[count++] = {row, row + 1};
    }
  }
  return count;
}

template <int n>
void BlockCholesky<n>::hand_out(std::size_t supernode) {
  const Supernode& lower = pattern_->supernodes()[supernode];
  const Index from_step = update_step<n>(lower);
  const std::size_t end = pattern_->shares_begin()[supernode + 1];
  for (std::size_t i = pattern_->shares_begin()[supernode]; i < end; ++i) {
    const BlockPattern::Share& share = pattern_->shares()[i];
    const int* rows = pattern_->rows_above().data() + share.rows;
    const std::size_t runs = find_runs(rows, lower.rows_below() - share.begin);
    const Index step = panel_step<n>(pattern_->supernodes()[at(share.supernode)]);
    double* panel = values_.get() + begin_[at(share.supernode)];
    for (int column = 0; column < share.end - share.begin; ++column) {
      const double* from = update_.get() + (share.begin + column) * n * from_step + share.begin * n;
      double* to = panel + rows[column] * n * step;
      for (std::size_t run = 0; run < runs; ++run) {
        const int row = std::max(runs_[run].first, column);
        if (row >= runs_[run].last) continue;
        subtract<n>(from + row * n, from_step, runs_[run].last - row, to + rows[row] * n, step);
      }
    }
  }
}

template <int n>
void BlockCholesky<n>::copy(const BlockMatrix<n>& matrix, double damping) {
  std::fill_n(values_.get(), size_, 0.0);
  double largest = 0.0;
  for (const auto& block : matrix.diagonal) {
    largest = std::max(largest, block.diagonal().maxCoeff());
  }
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    const int s = pattern_->supernode_of()[at(pattern_->place()[node])];
    const Index step = panel_step<n>(pattern_->supernodes()[at(s)]);
    typename BlockMatrix<n>::Block block = matrix.diagonal[node];
    block.diagonal() += damping * block.diagonal().cwiseMax(1e-9 * largest);
    put<n>(block, values_.get() + diagonal_[node], step);
  }
  for (std::size_t pair = 0; pair < beside_.size(); ++pair) {
    if (beside_[pair] >= 0) {
      put<n>(matrix.beside[pair], values_.get() + beside_[pair], step_[pair]);
    } else {
      put<n>(matrix.beside[pair].transpose(), values_.get() + ~beside_[pair], step_[pair]);
    }
  }
}

template <int n>
void BlockCholesky<n>::find_smallest_pivot(const BlockMatrix<n>& matrix, double damping) {
  smallest_pivot_ = 1.0;
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    const int s = pattern_->supernode_of()[at(pattern_->place()[node])];
    const Index step = panel_step<n>(pattern_->supernodes()[at(s)]);
    for (int i = 0; i < n; ++i) {
      const double inverse = values_.get()[diagonal_[node] + at(i * (step + 1))];
      const double before = matrix.diagonal[node](i, i) * (1.0 + damping);
      smallest_pivot_ = std::min(smallest_pivot_, 1.0 / (inverse * inverse * before));
    }
  }
}

template <int n>
void BlockCholesky<n>::solve(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::VectorXd ordered(x.size());
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    ordered.segment<n>(pattern_->place()[node] * Index{n}) =
        x.segment<n>(static_cast<Index>(node) * n);
  }
  const AlignedRoom room(at(highest_));
  double* dense = room.get();
  for (std::size_t s = 0; s < begin_.size(); ++s) solve_forward(s, dense, ordered);
  for (std::size_t s = begin_.size(); s-- > 0;) solve_backward(s, dense, ordered);
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    x.segment<n>(static_cast<Index>(node) * n) =
        ordered.segment<n>(pattern_->place()[node] * Index{n});
  }
}

template <int n>
void BlockCholesky<n>::solve_forward(std::size_t s, double* dense, Eigen::VectorXd& x) const {
  const Supernode& supernode = pattern_->supernodes()[s];
  const Index columns = supernode.columns() * Index{n};
  const Index step = panel_step<n>(supernode);
  const int* below = pattern_->rows().data() + supernode.below;
  double* own = x.data() + supernode.first * Index{n};
  std::copy_n(own, columns, dense);
  std::fill_n(dense + columns, step - columns, 0.0);
  dense_kernels().solve_forward(panel(s), step, columns, dense);
  std::copy_n(dense, columns, own);
  for (int i = 0; i < supernode.rows_below(); ++i) {
    double* to = x.data() + below[i] * Index{n};
    for (int j = 0; j < n; ++j) to[j] += dense[columns + i * n + j];
  }
}

template <int n>
void BlockCholesky<n>::solve_backward(std::size_t s, double* dense, Eigen::VectorXd& x) const {
  const Supernode& supernode = pattern_->supernodes()[s];
  const Index columns = supernode.columns() * Index{n};
  const Index step = panel_step<n>(supernode);
  const Index height = supernode.height * Index{n};
  const int* below = pattern_->rows().data() + supernode.below;
  double* own = x.data() + supernode.first * Index{n};
  std::copy_n(own, columns, dense);
  for (int i = 0; i < supernode.rows_below(); ++i) {
    std::copy_n(x.data() + below[i] * Index{n}, n, dense + columns + i * n);
  }
  std::fill_n(dense + height, step - height, 0.0);
  dense_kernels().solve_backward(panel(s), step, columns, dense);
  std::copy_n(dense, columns, own);
}

template class BlockCholesky<1>;
template class BlockCholesky<3>;
template class BlockCholesky<6>;

}  // namespace portolan
