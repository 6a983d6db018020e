// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/consensus.hpp"

#include <algorithm>
#include <utility>

namespace portolan {

void Chain::add(const UncertainPose& T_last_next) {
  if (poses_.empty()) {
    poses_.push_back(Pose::Identity());
    sums_.emplace_back(TangentMatrix::Zero());
    return;
  }
  poses_.push_back(poses_.back() * T_last_next.mean);
  const TangentMatrix A = adjoint(poses_.back());
  const TangentMatrix sum = sums_.back() + A * T_last_next.covariance * A.transpose();
  sums_.push_back(sum);
}

UncertainPose Chain::between(std::size_t i, std::size_t j) const {
  const Pose T_j_first = poses_[j].inverse();
  const TangentMatrix A = adjoint(T_j_first);
  const TangentMatrix sum = i < j ? sums_[j] - sums_[i] : sums_[i] - sums_[j];
  return {(T_j_first * poses_[i]).inverse(), A * sum * A.transpose()};
}

double disagreement(const Link& a, const Link& b, const Chain& chain) {
  const UncertainPose round = a.T_from_to * chain.between(a.to, b.to) * inverse(b.T_from_to) *
                              chain.between(b.from, a.from);
  return mahalanobis_squared(small_motion(round.mean), round.covariance, chain.space());
}

double chi_squared_limit(GraphSpace space) { return space == GraphSpace::planar ? 16.27 : 22.46; }

std::vector<std::size_t> consensus(const std::vector<Link>& loops, std::size_t with,
                                   const Chain& chain) {
  const double limit = chi_squared_limit(chain.space());
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i == with) continue;
    const double d = disagreement(loops[with], loops[i], chain);
    if (d <= limit) others.emplace_back(d, i);
  }
  std::sort(others.begin(), others.end());
  std::vector<std::size_t> clique = {with};
  for (const auto& [d, i] : others) {
    const auto agrees = [&, i = i](std::size_t j) {
      return disagreement(loops[i], loops[j], chain) <= limit;
    };
    if (std::all_of(clique.begin(), clique.end(), agrees)) clique.push_back(i);
  }
  std::sort(clique.begin(), clique.end());
  return clique;
}

}  // namespace portolan
