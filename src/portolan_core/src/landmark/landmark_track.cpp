// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_track.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "portolan/landmark/place_filter.hpp"

namespace portolan {

namespace {

/// Others may lie in the same direction: bearings alone never make a place so sure [log-odds] that
/// it outlives being looked through.
constexpr double kSurestByBearing = 5.0;

/// Huber's weight: 1 up to so many deviations, then falling with the distance.
double trust_in(const Fit& fit, double huber) {
  const double deviations = std::sqrt(fit.distance / fit.size);
  return deviations > huber ? huber / deviations : 1.0;
}

/// The product of two Gaussians that know nothing of each other.
Place fused(const Place& a, const Place& b) {
  const Eigen::Matrix3d K = a.covariance * (a.covariance + b.covariance).inverse();
  const Eigen::Matrix3d kept = Eigen::Matrix3d::Identity() - K;
  Place both = a;
  both.mean += K * (b.mean - a.mean);
  both.covariance = kept * a.covariance * kept.transpose() + K * b.covariance * K.transpose();
  both.covariance = (0.5 * (both.covariance + both.covariance.transpose())).eval();
  return both;
}

}  // namespace

LandmarkTrack::LandmarkTrack(const Measurement& first, const UncertainSensorPose& sensor,
                             const LandmarkOptions& options)
    : place_(first_place(first, sensor, options)), has_height_(tells_height(first)) {}

LandmarkTrack::LandmarkTrack(const Place& place, std::size_t sightings, double log_odds,
                             bool has_height)
    : place_(place), sightings_(sightings), log_odds_(log_odds), has_height_(has_height) {}

void LandmarkTrack::take(const Measurement& z, const UncertainSensorPose& sensor, const Fit& fit,
                         const LandmarkOptions& options) {
  update(place_, z, sensor, trust_in(fit, options.wrong.huber), options);
  ++sightings_;
  const double evidence = -std::log(options.existence.p_spurious);
  const bool has_range = shown_point(z, sensor.T_map_sensor).has_value();
  log_odds_ = has_range ? log_odds_ + evidence
                        : std::max(log_odds_, std::min(log_odds_ + evidence, kSurestByBearing));
  has_height_ |= tells_height(z);
  rival_.reset();
}

bool LandmarkTrack::contradict(const Measurement& z, const UncertainSensorPose& sensor, double gate,
                               const LandmarkOptions& options) {
  const std::optional<Fit> agrees = rival_ ? fit(rival_->place, z, sensor) : std::optional<Fit>{};
  if (agrees && agrees->distance < gate) {
    update(rival_->place, z, sensor, 1.0, options);
    ++rival_->sightings;
  } else {
    rival_ = Rival{first_place(z, sensor, options), 1};
  }
  if (rival_->sightings < std::min(sightings_ + 1, options.wrong.restart_after)) return false;
  place_ = rival_->place;
  sightings_ = rival_->sightings;
  rival_.reset();
  return true;
}

void LandmarkTrack::miss(double p_detection) { log_odds_ += std::log1p(-p_detection); }

void LandmarkTrack::absorb(const LandmarkTrack& other) {
  const Place both = fused(place_, other.place_);
  if (is_sound(both)) place_ = both;
  sightings_ += other.sightings_;
  log_odds_ += std::max(other.log_odds_, 0.0);
  has_height_ |= other.has_height_;
}

double LandmarkTrack::existence() const { return 1.0 / (1.0 + std::exp(-log_odds_)); }

}  // namespace portolan
