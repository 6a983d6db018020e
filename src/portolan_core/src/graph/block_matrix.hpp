// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace portolan {

/// A symmetric matrix of n x n blocks that has entries on its diagonal and for pairs of nodes.
template <int n>
struct BlockMatrix {
  using Block = Eigen::Matrix<double, n, n>;

  /// Zero, for nodes 0 to size - 1 and pairs of them, each once.
  BlockMatrix(std::size_t size, std::vector<std::pair<int, int>> its_pairs)
      : pairs(std::move(its_pairs)),
        diagonal(size, Block::Zero()),
        beside(pairs.size(), Block::Zero()) {}

  void set_zero() {
    std::fill(diagonal.begin(), diagonal.end(), Block::Zero());
    std::fill(beside.begin(), beside.end(), Block::Zero());
  }

  /// y = A x, by node.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i) * n;
      y.template segment<n>(at).noalias() = diagonal[i] * x.template segment<n>(at);
    }
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const Eigen::Index a = pairs[i].first * Eigen::Index{n};
      const Eigen::Index b = pairs[i].second * Eigen::Index{n};
      y.template segment<n>(a).noalias() += beside[i] * x.template segment<n>(b);
      y.template segment<n>(b).noalias() += beside[i].transpose() * x.template segment<n>(a);
    }
  }

  std::vector<std::pair<int, int>> pairs;
  std::vector<Block> diagonal;  // by node
  std::vector<Block> beside;    // by pair: in the row of its first node, the column of its second
};

}  // namespace portolan
