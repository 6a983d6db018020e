// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/beacon/beacon_options.hpp"
#include "portolan/beacon/hypothesis.hpp"
#include "portolan/beacon/range_update.hpp"
#include "portolan/beacon/travel.hpp"

namespace portolan {

/// All guesses of where one beacon is, heavier the better they explain its ranges.
class BeaconTrack {
 public:
  /// Takes the next range. `others` is the calibration's prior and what the other beacons say.
  void update(const PosedRange& z, const CalibrationPrior& prior, const CalibrationFactor& others,
              double drift, const BeaconOptions& options);

  /// The innovation of the last range times the trend of those before it, in standard deviations,
  /// each 1 at most: 0 on average where nothing drifts, above where places lag behind. 0 while
  /// ambiguous.
  double lag() const { return lag_; }

  /// The innovation of the last range in standard deviations. 0 while ambiguous.
  double surprise() const { return surprise_; }

  /// Never empty after the first range; the heaviest may stand anywhere. Weights sum to 1.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  /// The same in x, y, z, polar ones replaced by as many as it takes, and as drift has left them
  /// since the last range, now that the antenna has come as far as `now`.
  std::vector<Hypothesis> straightened(const Travel& now, const PoseDrift& drift,
                                       const RangeCalibration& calibration) const;
  const Hypothesis& best() const { return hypotheses_[best_]; }

  /// True while hypotheses three Mahalanobis distances from the best, or more, hold more than the
  /// options' `ambiguous_share` together.
  bool is_ambiguous() const { return is_ambiguous_; }

  /// What this beacon tells the others about the calibration: nothing while it is ambiguous.
  const CalibrationFactor& contribution() const { return contribution_; }

  /// Ranges taken, those of them that looked wrong, and how often it was started anew.
  std::size_t ranges() const { return ranges_; }
  std::size_t outliers() const { return outliers_; }
  std::size_t restarts() const { return restarts_; }

  /// The last range as it was taken, none since the track was restored; and the antenna at the
  /// first [m], the origin of polar places.
  const std::optional<PosedRange>& last() const { return last_; }
  const Eigen::Vector3d& origin() const { return origin_; }

  /// A track that was saved: Gaussians x, y, z with their weights, and its counts.
  static BeaconTrack restored(std::vector<Hypothesis> hypotheses, std::size_t ranges,
                              std::size_t outliers, std::size_t restarts,
                              const BeaconOptions& options);

 private:
  void start(const PosedRange& z, const RangeCalibration& calibration,
             const BeaconOptions& options);
  void forget(const PosedRange& z, const PoseDrift& drift, const RangeCalibration& calibration);
  void note(const RangeFit& fit);
  void weigh(const PosedRange& z, const CalibrationPrior& prior, const CalibrationFactor& others,
             const BeaconOptions& options);
  double normalize_and_prune(const BeaconOptions& options);
  void straighten(const RangeCalibration& calibration);
  void find_best();
  bool stands_elsewhere(const RangeCalibration& calibration, const BeaconOptions& options) const;

  std::vector<Hypothesis> hypotheses_;
  std::vector<double> fits_;  // P(the range was right | hypothesis), beside the hypotheses
  std::size_t best_ = 0;
  bool is_ambiguous_ = true;
  bool planar_ = true;
  bool polar_ = false;  // some hypotheses are
  CalibrationFactor contribution_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::optional<PosedRange> last_;
  Travel travel_;  // of the antenna when it was taken
  double lag_ = 0.0;
  double trend_ = 0.0;
  double surprise_ = 0.0;
  double fit_ = 0.0;     // recent mean of that
  double recent_ = 0.0;  // how many ranges are in it
  std::size_t ranges_ = 0;
  std::size_t outliers_ = 0;
  std::size_t restarts_ = 0;
};

}  // namespace portolan
