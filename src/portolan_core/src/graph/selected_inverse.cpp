// SPDX-License-Identifier: BSD-3-Clause
#include "graph/selected_inverse.hpp"

#include <cstddef>

namespace portolan {

namespace {

using Supernode = BlockPattern::Supernode;

// Z = A^-1 of a supernode: a square for its own columns, and what is below it.
struct Part {
  Eigen::MatrixXd own;
  Eigen::MatrixXd below;
};

template <int n>
class Takahashi {
 public:
  using Block = Eigen::Matrix<double, n, n>;

  explicit Takahashi(const BlockCholesky<n>& factor)
      : factor_(factor), pattern_(factor.pattern()), parts_(pattern_.supernodes().size()) {
    for (std::size_t s = parts_.size(); s-- > 0;) invert(s);
  }

  Block diagonal(int place) const {
    const auto s =
        static_cast<std::size_t>(pattern_.supernode_of()[static_cast<std::size_t>(place)]);
    const int at = (place - pattern_.supernodes()[s].first) * n;
    return parts_[s].own.template block<n, n>(at, at);
  }

 private:
  // With L = [L_c; L_b]: G = L_b L_c^-1, Z_b,c = -Z_b,b G, Z_c,c = (L_c L_c^T)^-1 - G^T Z_b,c.
  void invert(std::size_t s) {
    const Supernode& supernode = pattern_.supernodes()[s];
    const Eigen::Index columns = supernode.columns() * Eigen::Index{n};
    const Eigen::Index below = supernode.rows_below() * Eigen::Index{n};
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> panel(
        factor_.panel(s), columns + below, columns,
        Eigen::OuterStride<>(factor_.leading_dimension(s)));
    Eigen::MatrixXd corner = panel.topRows(columns);
    corner.diagonal() = corner.diagonal().cwiseInverse();
    const Eigen::MatrixXd root = corner.template triangularView<Eigen::Lower>().solve(
        Eigen::MatrixXd::Identity(columns, columns));
    const Eigen::MatrixXd G = panel.bottomRows(below) * root;
    parts_[s].below.noalias() = -(inverse_below(supernode) * G);
    parts_[s].own.noalias() = root.transpose() * root - G.transpose() * parts_[s].below;
  }

  // Z of the rows below, from the supernodes that have them as columns.
  Eigen::MatrixXd inverse_below(const Supernode& supernode) const {
    const int size = supernode.rows_below();
    const int* rows = pattern_.rows().data() + supernode.below;
    Eigen::MatrixXd Z(size * n, size * n);
    for (int j = 0; j < size; ++j) {
      const auto s =
          static_cast<std::size_t>(pattern_.supernode_of()[static_cast<std::size_t>(rows[j])]);
      const Supernode& holder = pattern_.supernodes()[s];
      const int column = (rows[j] - holder.first) * n;
      for (int i = j; i < size; ++i) {
        const int row = pattern_.row_in(holder, rows[i]);
        const bool own = row < holder.columns();
        const Eigen::MatrixXd& part = own ? parts_[s].own : parts_[s].below;
        const int at = (own ? row : row - holder.columns()) * n;
        Z.block<n, n>(i * n, j * n) = part.block<n, n>(at, column);
        Z.block<n, n>(j * n, i * n) = part.block<n, n>(at, column).transpose();
      }
    }
    return Z;
  }

  const BlockCholesky<n>& factor_;
  const BlockPattern& pattern_;
  std::vector<Part> parts_;
};

}  // namespace

template <int n>
std::vector<Eigen::Matrix<double, n, n>> inverse_diagonal(const BlockCholesky<n>& factor) {
  const Takahashi<n> inverse(factor);
  std::vector<Eigen::Matrix<double, n, n>> blocks;
  blocks.reserve(factor.pattern().place().size());
  for (const int place : factor.pattern().place()) blocks.push_back(inverse.diagonal(place));
  return blocks;
}

template std::vector<Eigen::Matrix<double, 3, 3>> inverse_diagonal(const BlockCholesky<3>&);
template std::vector<Eigen::Matrix<double, 6, 6>> inverse_diagonal(const BlockCholesky<6>&);

}  // namespace portolan
