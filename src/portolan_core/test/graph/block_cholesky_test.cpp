// SPDX-License-Identifier: BSD-3-Clause
#include "graph/block_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>
#include <set>
#include <type_traits>

namespace portolan {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

// A chain, and as many chords, short ones and long ones.
Pairs random_pairs(int size, std::size_t chords, std::mt19937_64& random) {
  std::set<std::pair<int, int>> pairs;
  for (int i = 0; i + 1 < size; ++i) pairs.emplace(i, i + 1);
  std::uniform_int_distribution<int> node(0, size - 1);
  while (pairs.size() < static_cast<std::size_t>(size) - 1 + chords) {
    const int a = node(random);
    const int b = node(random);
    if (a != b && pairs.count({b, a}) == 0) pairs.emplace(a, b);
  }
  return {pairs.begin(), pairs.end()};
}

template <int n>
BlockMatrix<n> random_matrix(int size, const Pairs& pairs, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const auto block = [&] {
    return BlockMatrix<n>::Block::NullaryExpr([&](auto, auto) { return entry(random); }).eval();
  };
  BlockMatrix<n> matrix(static_cast<std::size_t>(size), pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {  // as arcs do it: J^T J of both their ends
    const auto a = block();
    const auto b = block();
    matrix.diagonal[static_cast<std::size_t>(pairs[i].first)] += a.transpose() * a;
    matrix.diagonal[static_cast<std::size_t>(pairs[i].second)] += b.transpose() * b;
    matrix.beside[i] += a.transpose() * b;
  }
  for (auto& diagonal : matrix.diagonal) diagonal.diagonal().array() += 0.1;
  return matrix;
}

template <int n>
Eigen::MatrixXd dense(const BlockMatrix<n>& matrix) {
  const auto size = static_cast<Eigen::Index>(matrix.diagonal.size()) * n;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < matrix.diagonal.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i) * n;
    all.block<n, n>(at, at) = matrix.diagonal[i];
  }
  for (std::size_t i = 0; i < matrix.pairs.size(); ++i) {
    const int a = matrix.pairs[i].first * n;
    const int b = matrix.pairs[i].second * n;
    all.block<n, n>(a, b) = matrix.beside[i];
    all.block<n, n>(b, a) = matrix.beside[i].transpose();
  }
  return all;
}

template <class Size>
class BlockCholeskyTest : public ::testing::Test {};

template <int n>
using Blocks = std::integral_constant<int, n>;
using Sizes = ::testing::Types<Blocks<1>, Blocks<3>, Blocks<6>>;
TYPED_TEST_SUITE(BlockCholeskyTest, Sizes, );

TYPED_TEST(BlockCholeskyTest, solves_as_a_dense_factor_does) {
  constexpr int kSize = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    const int size = 2 + static_cast<int>(random() % 60);
    const std::size_t chords = size < 5 ? 0 : random() % static_cast<std::size_t>(2 * size);
    const Pairs pairs = random_pairs(size, chords, random);
    const BlockMatrix<kSize> matrix = random_matrix<kSize>(size, pairs, random);
    const BlockPattern pattern(Neighbours(size, pairs));
    BlockCholesky<kSize> cholesky(pattern, pairs);
    for (const double damping : {0.0, 0.5}) {
      Eigen::MatrixXd all = dense(matrix);
      all.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(all.rows(), -1.0, 2.0);
      ASSERT_TRUE(cholesky.factor(matrix, damping)) << seed;
      Eigen::VectorXd x = b;
      cholesky.solve(x);
      EXPECT_LT((all * x - b).norm(), 1e-10 * b.norm()) << seed;
      Eigen::VectorXd product(b.size());
      matrix.multiply(b, product);
      EXPECT_LT((product - dense(matrix) * b).norm(), 1e-12 * product.norm()) << seed;
    }
  }
}

TYPED_TEST(BlockCholeskyTest, solves_without_pairs) {
  constexpr int kSize = TypeParam::value;
  BlockMatrix<kSize> matrix(3, {});
  for (auto& block : matrix.diagonal) block.diagonal().setConstant(4.0);
  const BlockPattern pattern(Neighbours(3, {}));
  BlockCholesky<kSize> cholesky(pattern, {});
  ASSERT_TRUE(cholesky.factor(matrix));
  Eigen::VectorXd x = Eigen::VectorXd::Constant(3 * kSize, 8.0);
  cholesky.solve(x);
  EXPECT_EQ(x, Eigen::VectorXd::Constant(3 * kSize, 2.0));
}

TYPED_TEST(BlockCholeskyTest, tells_what_is_not_positive) {
  constexpr int kSize = TypeParam::value;
  std::mt19937_64 random(7);
  const Pairs pairs = random_pairs(20, 20, random);
  BlockMatrix<kSize> matrix = random_matrix<kSize>(20, pairs, random);
  const BlockPattern pattern(Neighbours(20, pairs));
  BlockCholesky<kSize> cholesky(pattern, pairs);
  ASSERT_TRUE(cholesky.factor(matrix));
  EXPECT_GT(cholesky.smallest_pivot(), 1e-6);
  EXPECT_LE(cholesky.smallest_pivot(), 1.0);
  matrix.diagonal[11](0, 0) = -0.1;
  EXPECT_FALSE(cholesky.factor(matrix));
}

TEST(BlockPattern, counts_what_a_chain_costs) {
  Pairs chain;
  for (int i = 0; i + 1 < 100; ++i) chain.emplace_back(i, i + 1);
  const BlockPattern pattern(Neighbours(100, chain));
  EXPECT_GE(pattern.entries(), 199.0);
  EXPECT_LT(pattern.entries(), 500.0);  // zeros that are worked on for the sake of width
}

}  // namespace
}  // namespace portolan
