// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/beacon/beacon_options.hpp"
#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

/// How well a hypothesis explained a range.
struct RangeFit {
  double log_likelihood = 0.0;  ///< ln p(z | hypothesis), Eq. 39, wrong ranges included
  double surprise = 0.0;        ///< innovation in standard deviations
  double p_right = 1.0;         ///< P(the range was no outlier | z, hypothesis)
};

/// Bayes' rule for one hypothesis and one range: weighs it by Eq. 39 with the outliers' density
/// beside the Gaussian, moves its place by an EKF (a UKF where it is polar about `origin`) in
/// which the range counts as much as it is likely to be right, and notes what the range says about
/// the calibration. `c` is the calibration given the prior, the other beacons and this hypothesis.
RangeFit update_hypothesis(const PosedRange& z, const RangeCalibration& c,
                           const RangeOutlierOptions& outliers, const Eigen::Vector3d& origin,
                           Hypothesis& hypothesis);

}  // namespace portolan
