// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/range_calibration.hpp"

#include <Eigen/LU>

namespace portolan {

CalibrationFactor& CalibrationFactor::operator+=(const CalibrationFactor& other) {
  information += other.information;
  vector += other.vector;
  return *this;
}

CalibrationFactor& CalibrationFactor::operator-=(const CalibrationFactor& other) {
  information -= other.information;
  vector -= other.vector;
  return *this;
}

CalibrationFactor operator+(CalibrationFactor a, const CalibrationFactor& b) { return a += b; }

CalibrationFactor operator-(CalibrationFactor a, const CalibrationFactor& b) { return a -= b; }

RangeCalibration CalibrationPrior::given(const CalibrationFactor& factor) const {
  RangeCalibration posterior;
  posterior.covariance = (information + factor.information).inverse();
  posterior.deviation = posterior.covariance * factor.vector;
  posterior.scale = scale + posterior.deviation[0];
  posterior.bias = bias + posterior.deviation[1];
  return posterior;
}

}  // namespace portolan
