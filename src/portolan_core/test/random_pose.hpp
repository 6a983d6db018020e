// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "portolan/pose.hpp"

namespace portolan {

/// A pose anywhere within ten metres, turned any way.
inline Pose random_pose(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  Eigen::Quaterniond q;
  for (int i = 0; i < 4; ++i) q.coeffs()[i] = normal(random);
  Pose pose = Pose::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  for (int i = 0; i < 3; ++i) pose.translation()[i] = coordinate(random);
  return pose;
}

}  // namespace portolan
