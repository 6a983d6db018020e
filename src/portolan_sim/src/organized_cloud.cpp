// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/organized_cloud.hpp"

#include <cmath>
#include <limits>

namespace portolan::sim {

void append(OrganizedCloud& organized, const Eigen::Vector3d& direction, double range) {
  if (std::isfinite(range)) {
    organized.cloud.points.emplace_back((range * direction).cast<float>());
    return;
  }
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  organized.cloud.points.emplace_back(kNan, kNan, kNan);
  if (range > 0.0) organized.cloud.no_returns.emplace_back(direction.cast<float>());
}

}  // namespace portolan::sim
