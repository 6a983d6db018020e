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

// The most that the stack holds at any time.
template <int n>
std::size_t stack_size(const BlockPattern& pattern, const std::vector<int>& children) {
  std::vector<std::size_t> sizes;
  std::size_t used = 0;
  std::size_t most = 0;
  for (std::size_t s = 0; s < pattern.supernodes().size(); ++s) {
    const std::size_t size = update_size<n>(pattern.supernodes()[s]);
    most = std::max(most, used + size);
    for (int child = 0; child < children[s]; ++child) {
      used -= sizes.back();
      sizes.pop_back();
    }
    sizes.push_back(size);
    used += size;
  }
  return most;
}

// Rows that stay neighbours on their way to the parent.
struct Run {
  int from;
  int to;
  int length;
};

std::vector<Run> runs(const int* rows_in_parent, int size) {
  std::vector<Run> all;
  for (int i = 0; i < size; ++i) {
    if (!all.empty() && rows_in_parent[i] == all.back().to + all.back().length) {
      ++all.back().length;
    } else {
      all.push_back({i, rows_in_parent[i], 1});
    }
  }
  return all;
}

void add(const double* from, Index size, double* to) {
  for (Index i = 0; i < size; ++i) to[i] += from[i];
}

template <int n>
void put(const typename BlockMatrix<n>::Block& block, double* to, Index step) {
  for (int j = 0; j < n; ++j) std::memcpy(to + j * step, block.col(j).data(), n * sizeof(double));
}

}  // namespace

template <int n>
BlockCholesky<n>::BlockCholesky(const BlockPattern& pattern, const BlockMatrix<n>& matrix)
    : pattern_(&pattern), children_(pattern.supernodes().size(), 0) {
  std::size_t end = 0;
  for (const Supernode& supernode : pattern.supernodes()) {
    begin_.push_back(end);
    end += panel_size<n>(supernode);
    if (supernode.parent >= 0) ++children_[at(supernode.parent)];
  }
  values_.resize(end);
  stack_.resize(stack_size<n>(pattern, children_));
  const auto find = [&](int row, int column) {
    const int s = pattern.supernode_of()[at(column)];
    const Supernode& supernode = pattern.supernodes()[at(s)];
    return begin_[at(s)] + at(pattern.row_in(supernode, row) * Index{n} +
                              (column - supernode.first) * n * panel_step<n>(supernode));
  };
  for (const int place : pattern.place()) diagonal_.push_back(find(place, place));
  for (const auto& [first, second] : matrix.pairs) {
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
  waiting_.clear();
  for (std::size_t s = 0; s < pattern_->supernodes().size(); ++s) {
    const Supernode& supernode = pattern_->supernodes()[s];
    const Index step = panel_step<n>(supernode);
    const Index columns = supernode.columns() * Index{n};
    double* panel = values_.data() + begin_[s];
    double* update = place_update(s);
    if (!dense_kernels().factor_panel(panel, step, columns)) return false;
    dense_kernels().subtract_square(update, update_step<n>(supernode),
                                    supernode.rows_below() * Index{n}, panel + columns, step,
                                    columns);
  }
  find_smallest_pivot(matrix, damping);
  return true;
}

template <int n>
void BlockCholesky<n>::copy(const BlockMatrix<n>& matrix, double damping) {
  std::fill(values_.begin(), values_.end(), 0.0);
  double largest = 0.0;
  for (const auto& block : matrix.diagonal) {
    largest = std::max(largest, block.diagonal().maxCoeff());
  }
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    const int s = pattern_->supernode_of()[at(pattern_->place()[node])];
    const Index step = panel_step<n>(pattern_->supernodes()[at(s)]);
    typename BlockMatrix<n>::Block block = matrix.diagonal[node];
    block.diagonal() += damping * block.diagonal().cwiseMax(1e-9 * largest);
    put<n>(block, &values_[diagonal_[node]], step);
  }
  for (std::size_t pair = 0; pair < beside_.size(); ++pair) {
    if (beside_[pair] >= 0) {
      put<n>(matrix.beside[pair], &values_[at(beside_[pair])], step_[pair]);
    } else {
      put<n>(matrix.beside[pair].transpose(), &values_[at(~beside_[pair])], step_[pair]);
    }
  }
}

// Room for the update that a supernode will make, with those of its children taken over. It is
// made above theirs and then moved down in their place.
template <int n>
double* BlockCholesky<n>::place_update(std::size_t supernode) {
  const std::size_t size = update_size<n>(pattern_->supernodes()[supernode]);
  const std::size_t top =
      waiting_.empty() ? 0
                       : waiting_.back().begin +
                             update_size<n>(pattern_->supernodes()[waiting_.back().supernode]);
  double* update = stack_.data() + top;
  std::fill(update, update + size, 0.0);
  std::size_t begin = top;
  for (int child = 0; child < children_[supernode]; ++child) {
    take_over(waiting_.back(), supernode, update);
    begin = waiting_.back().begin;
    waiting_.pop_back();
  }
  if (begin != top) std::memmove(stack_.data() + begin, update, size * sizeof(double));
  waiting_.push_back({supernode, begin});
  return stack_.data() + begin;
}

template <int n>
void BlockCholesky<n>::take_over(const Update& child, std::size_t supernode, double* update) {
  const Supernode& lower = pattern_->supernodes()[child.supernode];
  const Supernode& upper = pattern_->supernodes()[supernode];
  const std::vector<Run> moves =
      runs(pattern_->rows_in_parent().data() + lower.below, lower.rows_below());
  const double* from = stack_.data() + child.begin;
  const Index from_step = update_step<n>(lower);
  for (auto run = moves.begin(); run != moves.end(); ++run) {
    for (int i = 0; i < run->length; ++i) {
      const int column = run->to + i;
      const bool own = column < upper.columns();
      const Index step = own ? panel_step<n>(upper) : update_step<n>(upper);
      const Index shift = own ? 0 : upper.columns();
      double* to = own ? values_.data() + begin_[supernode] : update;
      to += (column - shift) * n * step - shift * n;
      for (int j = 0; j < n; ++j, from += from_step, to += step) {
        add(from + (run->from + i) * n, (run->length - i) * Index{n}, to + column * Index{n});
        for (auto next = run + 1; next != moves.end(); ++next) {
          add(from + next->from * n, next->length * Index{n}, to + next->to * Index{n});
        }
      }
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
      const double root = values_[diagonal_[node] + at(i * (step + 1))];
      const double before = matrix.diagonal[node](i, i) * (1.0 + damping);
      smallest_pivot_ = std::min(smallest_pivot_, root * root / before);
    }
  }
}

template <int n>
void BlockCholesky<n>::solve(Eigen::VectorXd& x) const {
  Eigen::VectorXd ordered(x.size());
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    ordered.segment<n>(pattern_->place()[node] * Index{n}) =
        x.segment<n>(static_cast<Index>(node) * n);
  }
  Eigen::VectorXd dense;
  for (std::size_t s = 0; s < begin_.size(); ++s) solve_forward(s, dense, ordered);
  for (std::size_t s = begin_.size(); s-- > 0;) solve_backward(s, dense, ordered);
  for (std::size_t node = 0; node < diagonal_.size(); ++node) {
    x.segment<n>(static_cast<Index>(node) * n) =
        ordered.segment<n>(pattern_->place()[node] * Index{n});
  }
}

template <int n>
void BlockCholesky<n>::solve_forward(std::size_t s, Eigen::VectorXd& dense,
                                     Eigen::VectorXd& x) const {
  const Supernode& supernode = pattern_->supernodes()[s];
  const Index columns = supernode.columns() * Index{n};
  const Index step = panel_step<n>(supernode);
  const int* below = pattern_->rows().data() + supernode.below;
  dense.setZero(step);
  dense.head(columns) = x.segment(supernode.first * Index{n}, columns);
  dense_kernels().solve_forward(panel(s), step, columns, dense.data());
  x.segment(supernode.first * Index{n}, columns) = dense.head(columns);
  for (int i = 0; i < supernode.rows_below(); ++i) {
    x.segment<n>(below[i] * Index{n}) += dense.segment<n>(columns + i * n);
  }
}

template <int n>
void BlockCholesky<n>::solve_backward(std::size_t s, Eigen::VectorXd& dense,
                                      Eigen::VectorXd& x) const {
  const Supernode& supernode = pattern_->supernodes()[s];
  const Index columns = supernode.columns() * Index{n};
  const Index step = panel_step<n>(supernode);
  const int* below = pattern_->rows().data() + supernode.below;
  dense.setZero(step);
  dense.head(columns) = x.segment(supernode.first * Index{n}, columns);
  for (int i = 0; i < supernode.rows_below(); ++i) {
    dense.segment<n>(columns + i * n) = x.segment<n>(below[i] * Index{n});
  }
  dense_kernels().solve_backward(panel(s), step, columns, dense.data());
  x.segment(supernode.first * Index{n}, columns) = dense.head(columns);
}

template class BlockCholesky<1>;
template class BlockCholesky<2>;
template class BlockCholesky<3>;
template class BlockCholesky<6>;

}  // namespace portolan
