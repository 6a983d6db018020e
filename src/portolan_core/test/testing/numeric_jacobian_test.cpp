// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/testing/numeric_jacobian.hpp"

#include <gtest/gtest.h>

#include <random>

#include "portolan/pose.hpp"

namespace portolan::testing {
namespace {

TEST(NumericJacobian, IsTheMatrixOfALinearFunction) {
  const Eigen::Matrix<double, 3, 2> A =
      (Eigen::Matrix<double, 3, 2>() << 1, 2, 3, 4, 5, 6).finished();
  const auto f = [&](const Eigen::Vector2d& x) { return A * x; };
  EXPECT_TRUE(numeric_jacobian(f, Eigen::Vector2d(-7.0, 0.1)).isApprox(A, 1e-9));
}

Eigen::Vector2d range_bearing(const Eigen::Vector2d& p) {
  return {p.norm(), std::atan2(p.y(), p.x())};
}

Eigen::Matrix2d range_bearing_jacobian(const Eigen::Vector2d& p) {
  const double r = p.norm();
  return (Eigen::Matrix2d() << p.x() / r, p.y() / r, -p.y() / (r * r), p.x() / (r * r)).finished();
}

TEST(NumericJacobian, FollowsACurvedFunction) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> coordinate(0.5, 20.0);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d p(coordinate(random), coordinate(random));
    const Eigen::Matrix2d error = numeric_jacobian(range_bearing, p) - range_bearing_jacobian(p);
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-8) << p.transpose();
  }
}

TEST(NumericJacobian, CrossesTheSeamOfAnglesWithADifferenceThatWraps) {
  const Eigen::Vector2d p(-2.0, 0.0);
  const auto wrapped = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return Eigen::Vector2d(a[0] - b[0], wrap_angle(a[1] - b[1]));
  };
  const Eigen::Matrix2d J = range_bearing_jacobian(p);
  EXPECT_TRUE(numeric_jacobian(range_bearing, p, wrapped).isApprox(J, 1e-8));
  EXPECT_FALSE(numeric_jacobian(range_bearing, p).isApprox(J, 1e-2));
}

TEST(NumericJacobian, StepsInProportionToLargeValues) {
  const auto f = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.array().square()); };
  const Eigen::VectorXd x = (Eigen::VectorXd(3) << 0.0, 1e-3, 1e6).finished();
  const Eigen::MatrixXd J = numeric_jacobian(f, x);
  ASSERT_EQ(J.rows(), 3);
  EXPECT_NEAR(J(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(J(1, 1), 2e-3, 1e-9);
  EXPECT_NEAR(J(2, 2), 2e6, 1e-2);
  EXPECT_EQ(J(0, 2), 0.0);
}

}  // namespace
}  // namespace portolan::testing
