// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace portolan {

/// What ranges to one beacon say about the calibration: a Gaussian factor in information form,
/// over the deviation (scale, bias [m], turn [rad/m]) from the prior mean.
struct CalibrationFactor {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();  ///< information * deviation

  CalibrationFactor& operator+=(const CalibrationFactor& other) {
    information += other.information;
    vector += other.vector;
    return *this;
  }
  CalibrationFactor& operator-=(const CalibrationFactor& other) {
    information -= other.information;
    vector -= other.vector;
    return *this;
  }
};

inline CalibrationFactor operator+(CalibrationFactor a, const CalibrationFactor& b) {
  return a += b;
}
inline CalibrationFactor operator-(CalibrationFactor a, const CalibrationFactor& b) {
  return a -= b;
}

/// What all ranges share: the device reads scale * distance + bias, and poses turn too far by
/// `turn` per way travelled, as wheels of unequal size make them. And how well that is known.
struct RangeCalibration {
  double scale = 1.0;
  double bias = 0.0;                                     ///< [m]
  double turn = 0.0;                                     ///< [rad/m]
  Eigen::Vector3d deviation = Eigen::Vector3d::Zero();   ///< (scale, bias, turn) minus prior mean
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (scale, bias, turn)
};

/// What is known of the calibration before any range.
struct CalibrationPrior {
  double scale = 1.0;
  double bias = 0.0;                                      ///< [m]
  double turn = 0.0;                                      ///< [rad/m]
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< inverse covariance; must be regular

  /// False where all three are as good as known, and no factor will change them.
  bool is_open() const { return information.diagonal().minCoeff() < kKnown; }

  /// False where poses are as good as known not to turn too far.
  bool turns() const { return turn != 0.0 || information(2, 2) < kKnown; }

  /// The prior times a factor.
  RangeCalibration given(const CalibrationFactor& factor) const {
    RangeCalibration posterior;
    posterior.covariance = (information + factor.information).inverse();
    posterior.deviation = posterior.covariance * factor.vector;
    posterior.scale = scale + posterior.deviation[0];
    posterior.bias = bias + posterior.deviation[1];
    posterior.turn = turn + posterior.deviation[2];
    return posterior;
  }

  static constexpr double kKnown = 1e18;  ///< information of what is as good as known
};

}  // namespace portolan
