// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/range_update.hpp"

#include <cmath>

#include "portolan/beacon/polar.hpp"

namespace portolan {

namespace {

constexpr double kPeak = 0.39894228040143267794;  // of the standard normal density
constexpr double kHardlyRight = 1e-3;  // a range less likely right than this moves nothing

double wrong_density(double innovation, const RangeOutlierOptions& outliers) {
  double density = (1.0 - outliers.late_share) / outliers.max_range;
  if (innovation > 0.0) {
    density +=
        outliers.late_share * std::exp(-innovation / outliers.late_mean) / outliers.late_mean;
  }
  return density;
}

RangeFit fit_of(double innovation, double variance, const RangeOutlierOptions& outliers) {
  const double surprise = innovation / std::sqrt(variance);
  const double right =
      (1.0 - outliers.share) * kPeak * std::exp(-0.5 * surprise * surprise) / std::sqrt(variance);
  const double wrong = outliers.share * wrong_density(innovation, outliers);
  return {std::log(right + wrong), surprise, right / (right + wrong)};
}

}  // namespace

RangeFit update_hypothesis(const PosedRange& z, const RangeCalibration& c,
                           const RangeOutlierOptions& outliers, const Eigen::Vector3d& origin,
                           Hypothesis& hypothesis) {
  const Eigen::Vector3d mean = hypothesis.mean(c);
  const DistancePrediction distance =
      hypothesis.is_polar ? predict_distance_polar(mean, hypothesis.Q, origin, z.p_map)
                          : predict_distance(mean, hypothesis.Q, z.p_map);
  // reading = scale * distance + bias, and how that depends on the calibration.
  const Eigen::RowVector3d L =
      c.scale * distance.H * hypothesis.G + Eigen::RowVector3d(distance.mean, 1.0, 0.0);
  const double innovation = z.range - c.scale * distance.mean - c.bias;
  const double expected = c.scale * c.scale * distance.variance;
  const double noise = z.stddev * z.stddev;
  const RangeFit fit =
      fit_of(innovation, expected + noise + L * c.covariance * L.transpose(), outliers);
  if (fit.p_right < kHardlyRight) return fit;

  const double S = expected + noise / fit.p_right;  // given the calibration
  const Eigen::Vector3d K = c.scale * distance.cross / S;
  const double at_prior = innovation + L * c.deviation;               // the innovation if c were 0
  const Eigen::Vector3d V = c.scale / std::sqrt(S) * distance.cross;  // S K K^T, symmetric to a bit
  const Eigen::Vector3d W = L.transpose() / S;
  hypothesis.x += K * at_prior;
  hypothesis.G -= K * L;
  hypothesis.Q -= V * V.transpose();
  hypothesis.calibration.information += W * L;
  hypothesis.calibration.vector += W * at_prior;
  return fit;
}

}  // namespace portolan
