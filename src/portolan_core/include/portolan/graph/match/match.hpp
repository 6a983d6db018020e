// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/graph/arc.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// What a matcher found: where the source lies in the target, how surely, and how well it fits.
struct Match {
  Pose T_target_source = Pose::Identity();
  /// Of T_target_source, as in an `Arc`; zero along the open directions.
  TangentMatrix information = TangentMatrix::Zero();
  /// Directions in which the surfaces do not hold the pose, such as along a corridor; unit length.
  std::vector<Tangent> open;
  double overlap = 0.0;  ///< share of the source's points that lie on the target
  double rms = 0.0;      ///< distance of those points from the target's surfaces [m]
  int iterations = 0;
  bool converged = false;
};

}  // namespace portolan
