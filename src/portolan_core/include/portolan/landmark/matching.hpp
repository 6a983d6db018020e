// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "portolan/landmark/landmark_track.hpp"
#include "portolan/landmark/place_filter.hpp"

namespace portolan {

/// A landmark that a sighting may show.
struct Candidate {
  std::size_t sighting = 0;  ///< which one of the message
  LandmarkId landmark = 0;
  Fit fit;
  JointTerm term;  ///< for joint compatibility; else unused
};

/// For each sighting of a message one of the candidates, or null. No landmark is taken twice.
using Matches = std::vector<const Candidate*>;

/// The most likely pair first, then the most likely one of what is left, and so on.
Matches match_nearest(const std::vector<Candidate>& candidates, std::size_t sightings);

/// The largest set of pairs whose errors fit together, since all share the error of one pose, and
/// of the largest the one that fits best: branch and bound (Neira and Tardos 2001). Where that
/// takes too long, the best set found until then. Candidates must be sorted by sighting.
Matches match_jointly(const std::vector<Candidate>& candidates, std::size_t sightings,
                      const PoseCovariance& pose_covariance, double gate);

}  // namespace portolan
