// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/hypothesis.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

DistancePrediction predict_distance(const Eigen::Vector3d& mean, const Eigen::Matrix3d& Q,
                                    const Eigen::Vector3d& p_map) {
  constexpr double kNearest = 1e-9;  // [m]; a place at the antenna has no direction
  DistancePrediction prediction;
  const Eigen::Vector3d v = mean - p_map;
  const double d = std::max(v.norm(), kNearest);
  const Eigen::Vector3d u = v / d;
  prediction.H = u.transpose();  // Eq. 39's H
  prediction.cross = Q * u;
  const double along = u.dot(prediction.cross);
  const double across = std::max(Q.trace() - along, 0.0);
  // The Hessian of |v| is (I - u u^T) / d; these are tr(Hessian Q) and tr((Hessian Q)^2).
  const double reach = std::max(d, std::sqrt(across));
  const double squared =
      std::max(Q.squaredNorm() - 2.0 * prediction.cross.squaredNorm() + along * along, 0.0);
  prediction.mean = d + 0.5 * across / reach;
  prediction.variance = along + 0.5 * squared / (reach * reach);
  return prediction;
}

}  // namespace portolan
