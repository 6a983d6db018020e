// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "portolan/beacon/beacon_estimate.hpp"
#include "portolan/beacon/beacon_options.hpp"
#include "portolan/beacon/beacon_track.hpp"
#include "portolan/observation/beacon_ranges.hpp"
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// Where beacons are, from ranges alone: each a sum of Gaussians until one remains.
///
/// Section 7, Eqs. 36-39, with two things more: what all ranges share, the device's scale and bias
/// and a turn that poses lack, is estimated along, and wrong ranges have a density of their own.
class BeaconMapper {
 public:
  using Options = BeaconOptions;
  using Observation = BeaconRanges;

  /// Throws OptionsError.
  explicit BeaconMapper(const Options& options);

  /// Takes what the antenna at the origin of `T_map_sensor` measured. What is malformed, too long
  /// or of a beacon too many is left out and counted: unusable where nothing was well-formed,
  /// rejected where nothing of it could be used.
  Outcome insert(const BeaconRanges& z, const Pose& T_map_sensor);

  const std::map<BeaconId, BeaconTrack>& tracks() const { return tracks_; }

  /// All that is known of each beacon, by id. Costs time in proportion to modes and beacons.
  std::vector<BeaconEstimate> estimates() const;

  /// The calibration given all ranges so far.
  RangeCalibration calibration() const { return prior_.given(evidence_); }

  /// The same in the form in which a mapper can go on from it.
  CalibrationPrior knowledge() const;

  /// How far poses drift per root of the way travelled, as learnt so far [m/sqrt(m)].
  double drift() const { return drift_; }

  /// How many times wider ranges spread than they state, as learnt so far; at least 1.
  double noise() const { return noise_; }

  const BeaconCounts& counts() const { return counts_; }
  const Options& options() const { return options_; }

  /// A mapper that goes on from saved tracks and from what was known of calibration, drift and
  /// noise.
  static BeaconMapper restored(const Options& options, const CalibrationPrior& prior, double drift,
                               double noise, std::map<BeaconId, BeaconTrack> tracks);

 private:
  void move_to(const Eigen::Vector3d& p_map);
  void learn_drift(double lag);
  void learn_noise(double surprise);
  bool take(const BeaconRange& z, const Eigen::Vector3d& p_map);

  Options options_;
  CalibrationPrior prior_;
  CalibrationFactor evidence_;  // the sum of the tracks' contributions
  std::map<BeaconId, BeaconTrack> tracks_;
  double drift_;
  double noise_ = 1.0;
  std::optional<Eigen::Vector3d> last_p_map_;  // of any antenna
  Travel travel_;
  BeaconCounts counts_;
};

}  // namespace portolan
