// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace portolan {

/// What ranges to one beacon say about the calibration: a Gaussian factor in information form,
/// over the deviation (scale, bias [m]) from the prior mean.
struct CalibrationFactor {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d vector = Eigen::Vector2d::Zero();  ///< information * deviation

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

/// How the ranging device reads: reading = scale * distance + bias, and how well that is known.
struct RangeCalibration {
  double scale = 1.0;
  double bias = 0.0;                                     ///< [m]
  Eigen::Vector2d deviation = Eigen::Vector2d::Zero();   ///< (scale, bias) minus the prior mean
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of (scale, bias)
};

/// What is known of the calibration before any range.
struct CalibrationPrior {
  double scale = 1.0;
  double bias = 0.0;                                      ///< [m]
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  ///< inverse covariance; must be regular

  /// False where scale and bias are as good as known, and no factor will change them.
  bool is_open() const { return information(0, 0) < kKnown || information(1, 1) < kKnown; }

  /// The prior times a factor.
  RangeCalibration given(const CalibrationFactor& factor) const {
    RangeCalibration posterior;
    posterior.covariance = (information + factor.information).inverse();
    posterior.deviation = posterior.covariance * factor.vector;
    posterior.scale = scale + posterior.deviation[0];
    posterior.bias = bias + posterior.deviation[1];
    return posterior;
  }

  static constexpr double kKnown = 1e18;  ///< information of what is as good as known
};

}  // namespace portolan
