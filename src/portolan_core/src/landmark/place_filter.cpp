// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/place_filter.hpp"

#include <Eigen/LU>
#include <cmath>

#include "portolan/landmark/expectation.hpp"
#include "portolan/landmark/inverse_sensor_model.hpp"
#include "portolan/landmark/unscented.hpp"

namespace portolan {

namespace {

template <class Model>
using Square = Eigen::Matrix<double, Model::kSize, Model::kSize>;

/// The sensor's errors, and those of its pose as the sensor sees them.
template <class Model>
Square<Model> noise(const Measured<Model>& measured, const Linearized<Model>& linear,
                    const UncertainSensorPose& sensor, double trust) {
  Square<Model> R = (measured.variance / trust).asDiagonal();
  if (sensor.is_certain) return R;
  const Eigen::Matrix<double, Model::kSize, 6> H_pose = by_pose(linear);
  R += H_pose * sensor.covariance * H_pose.transpose();
  return R;
}

template <class Model>
std::optional<Fit> fit_to(const Place& place, const Measured<Model>& measured,
                          const UncertainSensorPose& sensor) {
  const auto linear = linearize(place, measured, sensor.T_map_sensor);
  if (!linear) return std::nullopt;
  const Square<Model> S =
      linear->H * place.covariance * linear->H.transpose() + noise(measured, *linear, sensor, 1.0);
  const Square<Model> information = S.inverse();
  return Fit{linear->nu.dot(information * linear->nu), std::log(S.determinant()), Model::kSize};
}

template <class Model>
JointTerm term_of(const Place& place, const Measured<Model>& measured, const Pose& T_map_sensor) {
  const auto linear = linearize(place, measured, T_map_sensor);
  if (!linear) return {};
  Square<Model> S = linear->H * place.covariance * linear->H.transpose();
  S.diagonal() += measured.variance;
  const Square<Model> information = S.inverse();
  const typename Model::Vector weighted = information * linear->nu;
  const Eigen::Matrix<double, Model::kSize, 6> H_pose = by_pose(*linear);
  return {linear->nu.dot(weighted), H_pose.transpose() * information * H_pose,
          H_pose.transpose() * weighted, Model::kSize};
}

/// Eq. 23 with the covariance in Joseph's form: symmetric and positive whatever the rounding.
template <class Model>
void kalman_update(const Linearized<Model>& linear, const Square<Model>& R, Place& place) {
  const Square<Model> S = linear.H * place.covariance * linear.H.transpose() + R;
  const Eigen::Matrix<double, 3, Model::kSize> K =
      place.covariance * linear.H.transpose() * S.inverse();
  const Eigen::Matrix3d kept = Eigen::Matrix3d::Identity() - K * linear.H;
  place.mean += K * linear.nu;
  place.covariance = kept * place.covariance * kept.transpose() + K * R * K.transpose();
  place.covariance = (0.5 * (place.covariance + place.covariance.transpose())).eval();
}

/// True where the filter may look at h elsewhere than at the mean: not where the range of a ray is
/// measured, since a sigma point may lie at infinity there.
template <class Model>
bool can_be_unscented(const Place& place) {
  return Model::kScaleFree || place.form == PlaceForm::point;
}

/// The update of a ray by its bearing, linearised anew where it leads: the depth is so vague at
/// first that one step may lead astray.
template <class Model>
void iterated_update(const Measured<Model>& measured, const UncertainSensorPose& sensor,
                     double trust, Place& place) {
  constexpr int kIterations = 4;
  const Place prior = place;
  for (int i = 0; i < kIterations; ++i) {
    auto linear = linearize(place, measured, sensor.T_map_sensor);
    if (!linear) break;
    linear->nu += linear->H * (place.mean - prior.mean);
    place.covariance = prior.covariance;
    place.mean = prior.mean;
    kalman_update(*linear, noise(measured, *linear, sensor, trust), place);
  }
}

template <class Model>
void update_by(const Measured<Model>& measured, const UncertainSensorPose& sensor, double trust,
               LandmarkFilter filter, Place& place) {
  const auto linear = linearize(place, measured, sensor.T_map_sensor);
  if (!linear) return;
  const Square<Model> R = noise(measured, *linear, sensor, trust);
  if (filter == LandmarkFilter::ukf && can_be_unscented<Model>(place)) {
    unscented_update(measured, R, sensor.T_map_sensor, place);
  } else if (Model::kScaleFree && place.form == PlaceForm::ray) {
    iterated_update(measured, sensor, trust, place);
  } else {
    kalman_update(*linear, R, place);
  }
}

}  // namespace

std::optional<Fit> fit(const Place& place, const Measurement& measurement,
                       const UncertainSensorPose& sensor) {
  return std::visit([&](const auto& measured) { return fit_to(place, measured, sensor); },
                    measurement);
}

double JointTerm::distance(const PoseCovariance& pose_covariance) const {
  // By the matrix inversion lemma, in the form that allows for a pose that is known exactly.
  const PoseCovariance shared = PoseCovariance::Identity() + pose_covariance * information;
  return distance_alone - vector.dot(shared.partialPivLu().solve(pose_covariance * vector));
}

JointTerm operator+(JointTerm a, const JointTerm& b) {
  a.distance_alone += b.distance_alone;
  a.information += b.information;
  a.vector += b.vector;
  a.size += b.size;
  return a;
}

JointTerm joint_term(const Place& place, const Measurement& measurement, const Pose& T_map_sensor) {
  return std::visit([&](const auto& measured) { return term_of(place, measured, T_map_sensor); },
                    measurement);
}

Place first_place(const Measurement& measurement, const UncertainSensorPose& sensor,
                  const LandmarkOptions& options) {
  return std::visit(
      [&](const auto& measured) { return inverse_sensor_model(measured, sensor, options); },
      measurement);
}

void update(Place& place, const Measurement& measurement, const UncertainSensorPose& sensor,
            double trust, const LandmarkOptions& options) {
  Place updated = place;
  std::visit(
      [&](const auto& measured) { update_by(measured, sensor, trust, options.filter, updated); },
      measurement);
  if (!is_sound(updated)) return;
  place = updated;
  if (place.form == PlaceForm::point) return;
  const bool has_range = shown_point(measurement, sensor.T_map_sensor).has_value();
  const double index = InverseDepth::linearity_index(
      place.T_map_ray, place.mean, place.covariance(2, 2), sensor.T_map_sensor.translation());
  if (has_range || index < options.unmeasured.linearity)
    place = as_point(place, options.unmeasured.max_depth);
}

}  // namespace portolan
