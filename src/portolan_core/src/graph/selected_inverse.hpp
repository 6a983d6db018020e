// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "graph/block_cholesky.hpp"

namespace portolan {

/// The blocks on the diagonal of the inverse of a factored matrix, by node: Takahashi's recursion,
/// from the last supernode to the first. It needs the inverse only where the factor has entries.
template <int n>
std::vector<Eigen::Matrix<double, n, n>> inverse_diagonal(const BlockCholesky<n>& factor);

}  // namespace portolan
