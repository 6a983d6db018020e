// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace portolan {

/// What ranges to one beacon say about the calibration: a Gaussian factor in information form,
/// over the deviation (scale, bias [m]) from the prior mean.
struct CalibrationFactor {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d vector = Eigen::Vector2d::Zero();  ///< information * deviation

  CalibrationFactor& operator+=(const CalibrationFactor& other);
  CalibrationFactor& operator-=(const CalibrationFactor& other);
};

CalibrationFactor operator+(CalibrationFactor a, const CalibrationFactor& b);
CalibrationFactor operator-(CalibrationFactor a, const CalibrationFactor& b);

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

  /// The prior times a factor.
  RangeCalibration given(const CalibrationFactor& factor) const;
};

}  // namespace portolan
