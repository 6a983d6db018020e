// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/uncertainty.hpp"

#include <gtest/gtest.h>

#include <random>

#include "portolan/testing/numeric_jacobian.hpp"
#include "random_pose.hpp"

namespace portolan {
namespace {

TangentMatrix random_covariance(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  TangentMatrix a;
  for (int i = 0; i < 36; ++i) a(i / 6, i % 6) = 0.1 * normal(random);
  return a * a.transpose() + 0.01 * TangentMatrix::Identity();
}

TEST(Uncertainty, PropagatesAsTheDerivativesSay) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 20; ++run) {
    const UncertainPose a{random_pose(random), random_covariance(random)};
    const UncertainPose b{random_pose(random), random_covariance(random)};
    const Tangent zero = Tangent::Zero();
    const auto J_a = testing::numeric_jacobian(
        [&](const Tangent& v) {
          return small_motion((a.mean * b.mean).inverse() * a.mean * motion(v) * b.mean);
        },
        zero);
    const TangentMatrix expected = J_a * a.covariance * J_a.transpose() + b.covariance;
    EXPECT_TRUE((a * b).covariance.isApprox(expected, 1e-5));
    const auto J_inverse = testing::numeric_jacobian(
        [&](const Tangent& v) { return small_motion(a.mean * (a.mean * motion(v)).inverse()); },
        zero);
    const TangentMatrix turned = J_inverse * a.covariance * J_inverse.transpose();
    EXPECT_TRUE(inverse(a).covariance.isApprox(turned, 1e-5));
  }
}

TEST(Uncertainty, SmallMotionsAndTangentsAreInverse) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> small(-0.5, 0.5);
  for (int run = 0; run < 20; ++run) {
    Tangent v;
    for (int i = 0; i < 6; ++i) v[i] = small(random);
    EXPECT_TRUE(small_motion(motion(v)).isApprox(v, 1e-9));
  }
}

TEST(Uncertainty, WhatIsNotKnownHasALargeVariance) {
  TangentMatrix information = TangentMatrix::Zero();
  information(1, 1) = 4.0;
  information(5, 5) = 100.0;
  const TangentMatrix covariance = covariance_of(information, GraphSpace::planar);
  EXPECT_GE(covariance(0, 0), 1e6);
  EXPECT_DOUBLE_EQ(covariance(1, 1), 0.25);
  EXPECT_DOUBLE_EQ(covariance(2, 2), 0.0);
  EXPECT_DOUBLE_EQ(covariance(5, 5), 0.01);
  EXPECT_NEAR(information_of(covariance, GraphSpace::planar)(5, 5), 100.0, 1e-9);
}

TEST(Uncertainty, FusesInTheMiddleAndAlongWhatOneKnows) {
  Arc a;
  Arc b;
  b.T_from_to = planar_pose(1.0, 1.0, 0.0);
  b.information(0, 0) = 0.0;
  const UncertainPose both = fused(a, b, GraphSpace::planar);
  EXPECT_NEAR(both.mean.translation().x(), 0.0, 1e-9);
  EXPECT_NEAR(both.mean.translation().y(), 0.5, 1e-9);
  EXPECT_NEAR(both.covariance(0, 0), 1.0, 1e-9);
  EXPECT_NEAR(both.covariance(1, 1), 0.5, 1e-9);
}

}  // namespace
}  // namespace portolan
