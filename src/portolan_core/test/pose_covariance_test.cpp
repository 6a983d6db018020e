// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/pose_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace portolan {
namespace {

PoseCovariance some() {
  PoseCovariance root = PoseCovariance::Identity();
  for (Eigen::Index i = 0; i < root.size(); ++i)
    root(i) += 0.1 * std::sin(static_cast<double>(i * i));
  return root * root.transpose();
}

TEST(PoseCovariance, TurnsThereAndBack) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  EXPECT_LT((turned(turned(some(), R), R.transpose()) - some()).norm(), 1e-12);
}

TEST(PoseCovariance, TurnsWithTheAxes) {
  PoseCovariance along_x = PoseCovariance::Zero();
  along_x(0, 0) = 0.04;
  const Pose quarter = planar_pose(0.0, 0.0, 0.5 * M_PI);
  EXPECT_NEAR(turned(along_x, quarter.linear())(1, 1), 0.04, 1e-12);
}

TEST(PoseCovariance, AHeadingMovesWhatIsFarAway) {
  PoseCovariance heading = PoseCovariance::Zero();
  heading(5, 5) = 0.01;
  const PoseCovariance far = carried(heading, {2.0, 0.0, 0.0});
  EXPECT_NEAR(far(1, 1), 0.04, 1e-12);
  EXPECT_NEAR(far(1, 5), 0.02, 1e-12);
  EXPECT_EQ(far(0, 0), 0.0);
  EXPECT_LT((carried(carried(some(), {1.0, 2.0, 3.0}), {-1.0, -2.0, -3.0}) - some()).norm(), 1e-12);
}

TEST(PoseCovariance, ZerosAndNonsenseStateNothing) {
  EXPECT_TRUE(is_stated(some()));
  EXPECT_FALSE(is_stated(PoseCovariance::Zero()));
  EXPECT_FALSE(is_stated(-some()));
  PoseCovariance lopsided = some();
  lopsided(0, 1) += 1.0;
  EXPECT_FALSE(is_stated(lopsided));
  PoseCovariance unknown = some();
  unknown(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_stated(unknown));
  PoseCovariance planar = PoseCovariance::Zero();
  planar.diagonal() << 0.1, 0.1, 1e6, 1e6, 1e6, 0.1;
  EXPECT_TRUE(is_stated(planar));
  planar(0, 0) = -1.0;
  EXPECT_FALSE(is_stated(planar)) << "-1 stands for unknown";
}

TEST(PoseCovariance, WhatCanBeMeantIsBelievedAsItIs) {
  EXPECT_LT((believable(some()) - some()).norm(), 1e-12);
}

TEST(PoseCovariance, WhatCannotBeMeantIsBounded) {
  PoseCovariance wild = PoseCovariance::Zero();
  wild.diagonal() << 0.1, 0.1, 1e30, 1e6, 1e6, 0.1;
  wild(0, 1) = wild(1, 0) = 0.1 * (1.0 + 1e-7);  // rounding: a variance below zero along x - y
  const PoseCovariance bounded = believable(wild);
  EXPECT_NEAR(bounded(0, 0), 0.1, 1e-3);
  EXPECT_NEAR(bounded(2, 2), 1e6, 1e-3);
  EXPECT_NEAR(bounded(3, 3), 3.15 * 3.15, 1e-3);
  PoseCovariance lopsided = some();
  lopsided(0, 0) = -1e-9;
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> solver(believable(lopsided));
  EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-12);
}

}  // namespace
}  // namespace portolan
