// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/beacon_track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "portolan/beacon/inverse_range.hpp"
#include "portolan/beacon/merge.hpp"
#include "portolan/beacon/polar.hpp"

namespace portolan {

namespace {

constexpr double kApart = 3.0;            // Mahalanobis distance of places that are two
constexpr double kNewcomersFit = 0.5;     // one that starts wrong is given up soon,
constexpr double kNewcomersRanges = 8.0;  // as if so many had come before

bool lighter(const Hypothesis& a, const Hypothesis& b) { return a.log_weight < b.log_weight; }

}  // namespace

void BeaconTrack::update(const PosedRange& z, const CalibrationPrior& prior,
                         const CalibrationFactor& others, double drift,
                         const BeaconOptions& options) {
  ++ranges_;
  if (hypotheses_.empty()) {
    start(z, prior.given(others), options);
  } else {
    forget(z, {drift, prior.turns()}, prior.given(others));
    if (polar_)
      split_polar(z.p_map, z.stddev, origin_, prior.given(others), options.max_modes, hypotheses_);
    weigh(z, prior, others, options);
    const double p_right = normalize_and_prune(options);
    if (polar_) straighten(prior.given(others));
    merge_close(options.merge_distance, ranges_, z, hypotheses_);
    if (p_right < 0.5) ++outliers_;
    recent_ = std::min(recent_ + 1.0, options.restart.memory);
    fit_ += (p_right - fit_) / recent_;
    if (options.restart.enabled && fit_ < options.restart.fit_below) {
      ++restarts_;
      start(z, prior.given(others), options);
    }
  }
  last_ = z;
  travel_ = z.travel;
  find_best();
  is_ambiguous_ = stands_elsewhere(prior.given(others + best().calibration), options);
  contribution_ = is_ambiguous_ ? CalibrationFactor{} : best().calibration;
}

// Whether hypotheses apart from the best one weigh more than the given share.
bool BeaconTrack::stands_elsewhere(const RangeCalibration& calibration,
                                   const BeaconOptions& options) const {
  if (best().weight >= 1.0 - options.ambiguous_share) return false;
  double elsewhere = 0.0;
  for (const Hypothesis& h : hypotheses_) {
    const bool comparable = !h.is_polar && !best().is_polar;
    if (&h == &best()) continue;
    if (comparable && mahalanobis_distance(h, best(), calibration) < kApart) continue;
    elsewhere += h.weight;
    if (elsewhere > options.ambiguous_share) return true;
  }
  return false;
}

void BeaconTrack::start(const PosedRange& z, const RangeCalibration& calibration,
                        const BeaconOptions& options) {
  origin_ = z.p_map;
  if (options.space == BeaconSpace::planar) origin_.z() = 0.0;
  fit_ = kNewcomersFit;
  recent_ = kNewcomersRanges - 1.0;
  planar_ = options.space == BeaconSpace::planar;
  polar_ = options.parametrization == BeaconParametrization::polar;
  if (polar_) {
    inverse_range_polar(z, calibration, options, hypotheses_);
  } else {
    inverse_range(z, calibration, options, hypotheses_);
  }
  fits_.reserve(options.max_modes);
}

// Poses drift as the robot drives, and with them where the beacon seems to be.
void BeaconTrack::forget(const PosedRange& z, const PoseDrift& drift,
                         const RangeCalibration& calibration) {
  if (drift.drift == 0.0 && !drift.turns) return;
  const Travel leg = z.travel - travel_;
  for (Hypothesis& h : hypotheses_) carry(leg, drift, calibration, planar_, origin_, h);
}

void BeaconTrack::straighten(const RangeCalibration& calibration) {
  straighten_polar(origin_, calibration, hypotheses_);
  const auto is_polar = [](const Hypothesis& h) { return h.is_polar; };
  polar_ = std::any_of(hypotheses_.begin(), hypotheses_.end(), is_polar);
}

std::vector<Hypothesis> BeaconTrack::straightened(const Travel& now, const PoseDrift& drift,
                                                  const RangeCalibration& calibration) const {
  std::vector<Hypothesis> straight;
  straight.reserve(hypotheses_.size());
  for (const Hypothesis& h : hypotheses_) {
    if (h.is_polar) {
      append_straightened(h, origin_, calibration, straight);
    } else {
      straight.push_back(h);
    }
  }
  for (Hypothesis& h : straight) carry(now - travel_, drift, calibration, planar_, origin_, h);
  return straight;
}

void BeaconTrack::weigh(const PosedRange& z, const CalibrationPrior& prior,
                        const CalibrationFactor& others, const BeaconOptions& options) {
  fits_.clear();
  surprise_ = 0.0;
  lag_ = 0.0;
  RangeCalibration calibration = prior.given(others);
  const bool open = prior.is_open();
  for (Hypothesis& h : hypotheses_) {
    if (open) calibration = prior.given(others + h.calibration);
    const RangeFit fit = update_hypothesis(z, calibration, options.outliers, origin_, h);
    h.log_weight += fit.log_likelihood;
    if (fits_.size() == best_) note(fit);
    fits_.push_back(fit.p_right);
  }
}

// What the best hypothesis makes of a range tells of drift and noise, unless it is ambiguous.
void BeaconTrack::note(const RangeFit& fit) {
  constexpr double kMemory = 0.7;  // of the trend, from range to range
  constexpr double kMost = 2.0;
  if (is_ambiguous_) {
    trend_ = 0.0;
    return;
  }
  surprise_ = fit.surprise;
  if (fit.p_right < 0.5) return;  // wrong ranges come in runs: they would look like drift
  lag_ = std::clamp(trend_, -1.0, 1.0) * std::clamp(surprise_, -1.0, 1.0);
  trend_ =
      kMemory * trend_ + std::sqrt(1.0 - kMemory * kMemory) * std::clamp(surprise_, -kMost, kMost);
}

// Returns P(the last range was right).
double BeaconTrack::normalize_and_prune(const BeaconOptions& options) {
  const double heaviest =
      std::max_element(hypotheses_.begin(), hypotheses_.end(), lighter)->log_weight;
  const double lightest = heaviest + std::log(options.prune_below);
  double p_right = 0.0;
  double mass = 0.0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    if (hypotheses_[i].log_weight < lightest) continue;
    if (kept != i) hypotheses_[kept] = hypotheses_[i];
    const double weight = std::exp(hypotheses_[kept].log_weight - heaviest);
    hypotheses_[kept++].weight = weight;
    p_right += fits_[i] * weight;
    mass += weight;
  }
  hypotheses_.resize(kept);
  for (Hypothesis& h : hypotheses_) {
    h.weight /= mass;
    h.log_weight -= heaviest + std::log(mass);
  }
  return p_right / mass;
}

void BeaconTrack::find_best() {
  const auto best = std::max_element(hypotheses_.begin(), hypotheses_.end(), lighter);
  best_ = static_cast<std::size_t>(best - hypotheses_.begin());
}

BeaconTrack BeaconTrack::restored(std::vector<Hypothesis> hypotheses, std::size_t ranges,
                                  std::size_t outliers, std::size_t restarts,
                                  const BeaconOptions& options) {
  BeaconTrack track;
  track.hypotheses_ = std::move(hypotheses);
  track.ranges_ = ranges;
  track.outliers_ = outliers;
  track.restarts_ = restarts;
  track.fit_ = 1.0;
  track.recent_ = options.restart.memory;
  track.planar_ = options.space == BeaconSpace::planar;
  track.find_best();
  track.is_ambiguous_ = track.stands_elsewhere({}, options);
  return track;
}

}  // namespace portolan
