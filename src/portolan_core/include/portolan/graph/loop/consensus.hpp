// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/loop/reckoning.hpp"

namespace portolan {

/// The way along the keyframes, each measured from the one before, with what is uncertain of it.
/// Gives the way between any two in constant time.
class Chain {
 public:
  explicit Chain(GraphSpace space) : space_(space) {}

  /// The next keyframe, seen from the one before; the first one lies at the origin.
  void add(const UncertainPose& T_last_next);

  std::size_t size() const { return poses_.size(); }
  const Pose& T_first(std::size_t i) const { return poses_[i]; }
  /// T_i_j, whichever comes first.
  UncertainPose between(std::size_t i, std::size_t j) const;
  GraphSpace space() const { return space_; }

 private:
  GraphSpace space_;
  std::vector<Pose> poses_;
  std::vector<TangentMatrix> sums_;  // covariances of all steps so far, in the first one's frame
};

/// The squared Mahalanobis distance from closing of the way round: along one loop's arc, along the
/// chain, back along the other's arc, and back along the chain (pairwise consistency; Mangelson et
/// al. 2018). Chi-squared of 3 degrees of freedom in the plane, 6 in space.
double disagreement(const Link& a, const Link& b, const Chain& chain);

/// The limit that chi^2 exceeds by chance once in a thousand times.
double chi_squared_limit(GraphSpace space);

/// Of the loops, those that agree with the one of this index and with each other, itself included:
/// a clique, grown from the nearest in agreement on.
std::vector<std::size_t> consensus(const std::vector<Link>& loops, std::size_t with,
                                   const Chain& chain);

}  // namespace portolan
