// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "portolan/beacon/range_calibration.hpp"

namespace portolan {

/// How far an antenna has come, and where on the way it was.
struct Travel {
  double way = 0.0;                                  ///< [m]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< integral of its place over the way [m^2]
};

inline Travel operator-(const Travel& to, const Travel& from) {
  return {to.way - from.way, to.moment - from.moment};
}

/// A range to one beacon, and where its antenna was.
struct PosedRange {
  Eigen::Vector3d p_map = Eigen::Vector3d::Zero();  ///< of the antenna [m]
  double range = 0.0;                               ///< as read [m]
  double stddev = 0.1;                              ///< of the reading [m]
  Travel travel;                                    ///< of the antenna so far
};

/// One guess of where a beacon is: a Gaussian whose mean depends on the calibration.
///
/// Given the calibration, beacons do not know of each other. So each guess keeps its place *given*
/// the calibration, p(m | c) = N(x + G c, Q) with c the deviation from the calibration's prior
/// mean, and what its ranges say about c. The joint estimate of all beacons and the calibration is
/// then exact to first order, and a range costs the same however many beacons there are.
struct Hypothesis {
  double weight = 1.0;  ///< of all that this beacon has
  double log_weight = 0.0;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< place for c = 0; x, y, z or polar
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();  ///< covariance given c
  Eigen::Matrix3d G = Eigen::Matrix3d::Zero();  ///< d place / d c
  CalibrationFactor calibration;                ///< what its ranges say
  bool is_polar = false;  ///< place is distance [m], azimuth, elevation [rad] about an origin

  /// The place [m or rad] if this is the calibration, and its covariance with c unknown.
  Eigen::Vector3d mean(const RangeCalibration& c) const { return x + G * c.deviation; }
  Eigen::Matrix3d covariance(const RangeCalibration& c) const {
    return Q + G * c.covariance * G.transpose();
  }
};

/// What a hypothesis expects of the distance from an antenna, given the calibration.
struct DistancePrediction {
  double mean = 0.0;                                  ///< [m]
  double variance = 0.0;                              ///< [m^2]
  Eigen::Vector3d cross = Eigen::Vector3d::Zero();    ///< covariance of place and distance
  Eigen::RowVector3d H = Eigen::RowVector3d::Zero();  ///< d distance / d place
};

/// Eq. 36 for a Gaussian place x, y, z, to second order: the mean distance is longer, and less
/// certain, than that of the mean by what the sphere curves within the Gaussian.
inline DistancePrediction predict_distance(const Eigen::Vector3d& mean, const Eigen::Matrix3d& Q,
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
