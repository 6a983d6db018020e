// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/matching.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <set>
#include <tuple>

#include "portolan/landmark/chi_squared.hpp"

namespace portolan {

namespace {

bool is_taken(LandmarkId landmark, const Matches& matches) {
  return std::any_of(matches.begin(), matches.end(), [&](const Candidate* match) {
    return match != nullptr && match->landmark == landmark;
  });
}

/// The search for the largest set of pairs that fit together.
class Search {
 public:
  Search(const std::vector<Candidate>& candidates, std::size_t sightings,
         const PoseCovariance& pose_covariance, double gate)
      : candidates_(candidates), pose_covariance_(pose_covariance) {
    current_.resize(sightings, nullptr);
    best_ = current_;
    for (std::size_t size = 0; size <= 3 * sightings; ++size)
      gates_.push_back(size == 0 ? 0.0 : chi_squared_quantile(gate, size));
  }

  Matches best() {
    branch(0, 0, 0, JointTerm{});
    return best_;
  }

 private:
  static constexpr std::size_t kMostSteps = 20000;

  void branch(std::size_t sighting, std::size_t first, std::size_t pairs, const JointTerm& sum) {
    if (pairs + (current_.size() - sighting) < best_pairs_ || ++steps_ > kMostSteps) return;
    if (sighting == current_.size()) {
      keep_if_best(pairs, sum);
      return;
    }
    std::size_t end = first;
    while (end < candidates_.size() && candidates_[end].sighting == sighting) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const Candidate& candidate = candidates_[i];
      if (is_taken(candidate.landmark, current_)) continue;
      const JointTerm with = sum + candidate.term;
      if (with.distance(pose_covariance_) > gates_[static_cast<std::size_t>(with.size)]) continue;
      current_[sighting] = &candidate;
      branch(sighting + 1, end, pairs + 1, with);
      current_[sighting] = nullptr;
    }
    branch(sighting + 1, end, pairs, sum);
  }

  void keep_if_best(std::size_t pairs, const JointTerm& sum) {
    const double distance = sum.distance(pose_covariance_);
    if (pairs < best_pairs_ || (pairs == best_pairs_ && distance >= best_distance_)) return;
    best_ = current_;
    best_pairs_ = pairs;
    best_distance_ = distance;
  }

  const std::vector<Candidate>& candidates_;
  const PoseCovariance& pose_covariance_;
  std::vector<double> gates_;  // by how many numbers were measured
  Matches current_;
  Matches best_;
  std::size_t best_pairs_ = 0;
  double best_distance_ = 0.0;
  std::size_t steps_ = 0;
};

}  // namespace

Matches match_nearest(const std::vector<Candidate>& candidates, std::size_t sightings) {
  std::vector<const Candidate*> order;
  order.reserve(candidates.size());
  for (const Candidate& candidate : candidates) order.push_back(&candidate);
  const auto key = [](const Candidate* c) {
    return std::make_tuple(c->fit.cost(), c->sighting, c->landmark);
  };
  std::sort(order.begin(), order.end(),
            [&](const Candidate* a, const Candidate* b) { return key(a) < key(b); });
  Matches matches(sightings, nullptr);
  std::set<LandmarkId> taken;
  for (const Candidate* candidate : order) {
    const Candidate*& match = matches[candidate->sighting];
    if (match == nullptr && taken.insert(candidate->landmark).second) match = candidate;
  }
  return matches;
}

Matches match_jointly(const std::vector<Candidate>& candidates, std::size_t sightings,
                      const PoseCovariance& pose_covariance, double gate) {
  return Search(candidates, sightings, pose_covariance, gate).best();
}

}  // namespace portolan
