// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "portolan/landmark/inverse_depth.hpp"
#include "portolan/landmark/measurement.hpp"
#include "portolan/landmark/place.hpp"

namespace portolan {

/// What the sensor would measure of the place if its coordinates were `x`.
template <class Model>
typename Model::Vector expected(const Model& model, const Place& place, const Eigen::Vector3d& x,
                                const Pose& T_map_sensor) {
  if (place.form == PlaceForm::ray)
    return model.h(InverseDepth::scaled_in_sensor(place.T_map_ray, x, T_map_sensor));
  const Eigen::Vector3d l = T_map_sensor.linear().transpose() * (x - T_map_sensor.translation());
  return model.h(l);
}

/// The update of the unscented Kalman filter: seven points stand for the Gaussian, and the mean
/// and covariance of what would be measured of each replace the linearisation.
template <class Model>
void unscented_update(const Measured<Model>& measured,
                      const Eigen::Matrix<double, Model::kSize, Model::kSize>& R,
                      const Pose& T_map_sensor, Place& place) {
  constexpr int kSize = Model::kSize;
  constexpr int kPairs = 3;
  constexpr double kSpread = 3.0;  // n + kappa: exact to fourth moments of a Gaussian
  constexpr double kWeight = 0.5 / kSpread;
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(place.covariance);
  Eigen::Matrix3d root = ldlt.transpositionsP().transpose() * Eigen::Matrix3d(ldlt.matrixL());
  root *= (kSpread * ldlt.vectorD().cwiseMax(0.0)).cwiseSqrt().asDiagonal();

  const auto at_mean = expected(measured.model, place, place.mean, T_map_sensor);
  Eigen::Matrix<double, kSize, 2 * kPairs> off;  // from what is expected at the mean
  for (int i = 0; i < kPairs; ++i) {
    for (int side = 0; side < 2; ++side) {
      const Eigen::Vector3d x = place.mean + (side == 0 ? 1.0 : -1.0) * root.col(i);
      off.col(2 * i + side) =
          Model::difference(expected(measured.model, place, x, T_map_sensor), at_mean);
    }
  }
  const typename Model::Vector shift = kWeight * off.rowwise().sum();
  const Eigen::Matrix<double, kSize, kSize> S =
      kWeight * off * off.transpose() - shift * shift.transpose() + R;
  Eigen::Matrix<double, 3, kSize> cross = Eigen::Matrix<double, 3, kSize>::Zero();
  for (int i = 0; i < kPairs; ++i)
    cross += kWeight * root.col(i) * (off.col(2 * i) - off.col(2 * i + 1)).transpose();

  const Eigen::Matrix<double, 3, kSize> K = cross * S.inverse();
  place.mean += K * (Model::difference(measured.z, at_mean) - shift);
  // P - K S K' as a sum of squares, which rounding cannot make negative.
  Eigen::Matrix3d covariance = K * R * K.transpose();
  for (int i = 0; i < 2 * kPairs; ++i) {
    const Eigen::Vector3d step = (i % 2 == 0 ? 1.0 : -1.0) * root.col(i / 2);
    const Eigen::Vector3d left = step - K * (off.col(i) - shift);
    covariance += kWeight * left * left.transpose();
  }
  place.covariance = covariance;
  place.covariance = (0.5 * (place.covariance + place.covariance.transpose())).eval();
}

}  // namespace portolan
