// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/beacon_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "portolan/beacon/expected_information.hpp"
#include "portolan/observation/limits.hpp"

namespace portolan {

namespace {

double information_of(double stddev) {
  return std::min(1.0 / (stddev * stddev), CalibrationPrior::kKnown);
}

CalibrationPrior prior_of(const RangeCalibrationOptions& options) {
  CalibrationPrior prior;
  prior.scale = options.scale;
  prior.bias = options.bias;
  prior.information(0, 0) = information_of(options.scale_stddev);
  prior.information(1, 1) = information_of(options.bias_stddev);
  prior.information(2, 2) = information_of(options.turn_stddev);
  return prior;
}

// The plane of the beacons is z = 0; the antenna then is below it by their height.
Eigen::Vector3d antenna(const Pose& T_map_sensor, const BeaconOptions& options) {
  Eigen::Vector3d p_map = T_map_sensor.translation();
  if (options.space == BeaconSpace::planar) p_map.z() = -options.height;
  return p_map;
}

}  // namespace

BeaconMapper::BeaconMapper(const Options& options)
    : options_(checked(options)), prior_(prior_of(options.calibration)), drift_(options.drift) {}

Outcome BeaconMapper::insert(const BeaconRanges& z, const Pose& T_map_sensor) {
  const Eigen::Vector3d p_map = antenna(T_map_sensor, options_);
  bool took_any = z.ranges.empty();
  if (took_any) move_to(p_map);
  for (const BeaconRange& range : z.ranges) took_any |= take(range, p_map);
  if (took_any) return Outcome::inserted;
  return is_usable(z) ? Outcome::rejected : Outcome::unusable;
}

void BeaconMapper::move_to(const Eigen::Vector3d& p_map) {
  if (last_p_map_) {
    const double step = (p_map - *last_p_map_).norm();
    travel_.way += step;
    travel_.moment += step * 0.5 * (p_map + *last_p_map_);
  }
  last_p_map_ = p_map;
}

bool BeaconMapper::take(const BeaconRange& z, const Eigen::Vector3d& p_map) {
  if (!is_usable(z)) return ++counts_.malformed, false;
  if (z.range > options_.outliers.max_range) return ++counts_.too_long, false;
  auto track = tracks_.find(z.id);
  if (track == tracks_.end()) {
    if (tracks_.size() == options_.max_beacons) return ++counts_.refused, false;
    track = tracks_.emplace(z.id, BeaconTrack{}).first;
  }
  move_to(p_map);  // not before: what is rejected enters no log, and leaves no trace here
  const double stated = std::max(z.stddev > 0.0 ? z.stddev : options_.stddev, kSharpestDistance);
  const PosedRange range{p_map, z.range, noise_ * stated, travel_};
  const CalibrationFactor others = evidence_ - track->second.contribution();
  track->second.update(range, prior_, others, drift_, options_);
  if (options_.learn_drift) learn_drift(track->second.lag());
  if (options_.learn_noise) learn_noise(track->second.surprise());
  evidence_ = others + track->second.contribution();
  ++counts_.taken;
  return true;
}

// Innovations of a filter that believes in the right drift are white (Mehra 1970): raise it while
// they agree in sign with those before them, lower it while they do not. They also agree where
// errors stay for a while that are no drift: of poses that come late, of wrong ranges in a run.
// Learnt without bound these would make the map forget what is right and follow what is wrong;
// beyond the bound they count as noise. The bound leaves what the estimate scatters by where poses
// drift as the options state: 0.74 to 1.41 in `learnt_drift_test`.
void BeaconMapper::learn_drift(double lag) {
  constexpr double kGain = 0.05;
  constexpr double kTolerated = 0.05;  // geometry and reflections correlate innovations as well
  constexpr double kLeast = 0.0025;    // of the drift that the options state
  constexpr double kMost = 1.5;
  if (lag == 0.0) return;
  drift_ = std::clamp(drift_ * std::exp(kGain * (lag - kTolerated)), kLeast * options_.drift,
                      kMost * options_.drift);
}

// Honest deviations leave as many innovations above their median as below it; a median bears with
// wrong ranges.
void BeaconMapper::learn_noise(double surprise) {
  constexpr double kGain = 0.01;
  constexpr double kMedian = 0.6744897501960817;  // of a standard normal variable's size
  constexpr double kMost = 50.0;
  if (surprise == 0.0) return;
  const double larger = std::abs(surprise) > kMedian ? 1.0 : -1.0;
  noise_ = std::clamp(noise_ * std::exp(kGain * larger), 1.0, kMost);
}

CalibrationPrior BeaconMapper::knowledge() const {
  const RangeCalibration now = calibration();
  return {now.scale, now.bias, now.turn, prior_.information + evidence_.information};
}

std::vector<BeaconEstimate> BeaconMapper::estimates() const {
  std::vector<BeaconEstimate> all;
  all.reserve(tracks_.size());
  for (const auto& [id, track] : tracks_) {
    BeaconEstimate estimate;
    estimate.id = id;
    estimate.ranges = track.ranges();
    estimate.outliers = track.outliers();
    estimate.restarts = track.restarts();
    estimate.ambiguous = track.is_ambiguous();
    const CalibrationFactor others = evidence_ - track.contribution();
    const PoseDrift drift{drift_, prior_.turns()};
    for (const Hypothesis& h : track.straightened(travel_, drift, prior_.given(others))) {
      const RangeCalibration c = prior_.given(others + h.calibration);
      estimate.modes.push_back({h.weight, h.mean(c), h.covariance(c)});
    }
    const auto heavier = [](const BeaconMode& a, const BeaconMode& b) {
      return a.weight > b.weight;
    };
    std::stable_sort(estimate.modes.begin(), estimate.modes.end(), heavier);
    if (track.last()) {
      const PosedRange& last = *track.last();
      estimate.drive = best_drive(estimate.modes, last.p_map, last.stddev, options_.space);
    }
    all.push_back(std::move(estimate));
  }
  return all;
}

BeaconMapper BeaconMapper::restored(const Options& options, const CalibrationPrior& prior,
                                    double drift, double noise,
                                    std::map<BeaconId, BeaconTrack> tracks) {
  BeaconMapper mapper(options);
  mapper.prior_ = prior;
  mapper.drift_ = drift;
  mapper.noise_ = noise;
  mapper.tracks_ = std::move(tracks);
  for (const auto& [id, track] : mapper.tracks_) mapper.counts_.taken += track.ranges();
  return mapper;
}

}  // namespace portolan
