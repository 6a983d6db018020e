// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/loop_search.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/graph/loop/consensus.hpp"

namespace portolan {

namespace {

constexpr double kSigmas = 3.0;

double deviation_along(const Eigen::Vector3d& direction, const TangentMatrix& covariance) {
  const Eigen::Vector3d d = direction.normalized();
  return std::sqrt(std::max(0.0, d.dot(covariance.topLeftCorner<3, 3>() * d)));
}

// How far the place lies beyond what is uncertain of it; 0 where it may be right here [m].
double certain_distance(const UncertainPose& T_now_place) {
  const Eigen::Vector3d p_place =
      T_now_place.mean.linear().transpose() * T_now_place.mean.translation();
  const double distance = p_place.norm();
  if (distance == 0.0) return 0.0;
  return std::max(0.0, distance - kSigmas * deviation_along(p_place, T_now_place.covariance));
}

double largest_variance(const Eigen::Matrix2d& xy) {
  const double half = 0.5 * xy.trace();
  return half + std::sqrt(std::max(0.0, half * half - xy.determinant()));
}

// How uncertain it is where the place's surfaces lie: of its position, and of what its heading
// moves [m].
double doubt_of(const UncertainPose& T_now_place, double lever) {
  const TangentMatrix& covariance = T_now_place.covariance;
  return std::sqrt(largest_variance(covariance.topLeftCorner<2, 2>()) +
                   lever * lever * covariance(5, 5));
}

// Within these, closest points find the way by themselves.
bool is_narrow(const SearchWindow& window) { return window.reach < 0.5 && window.turn < 0.15; }

// Whether the graph knows well enough where the open directions leave the pose.
bool is_held(const Match& match, const TangentMatrix& covariance, const LoopOptions& options) {
  const auto held = [&](const Tangent& open) {
    return std::sqrt(open.dot(covariance * open)) <= options.max_open;
  };
  return std::all_of(match.open.begin(), match.open.end(), held);
}

// How far the match lies from what was expected, in the directions that it measures.
double surprise(const Match& match, const UncertainPose& expected) {
  const Tangent v = small_motion(expected.mean.inverse() * match.T_target_source);
  const TangentMatrix covariance =
      expected.covariance + covariance_of(match.information, GraphSpace::planar);
  return mahalanobis_squared(v, covariance, GraphSpace::planar);
}

ArcReason judge(const LoopFinding& finding, const UncertainPose& expected,
                const LoopOptions& options) {
  if (!finding.match.converged) return ArcReason::poor_match;
  if (finding.agreement.shared < options.min_shared) return ArcReason::low_overlap;
  if (finding.agreement.agreed < options.min_agreed) return ArcReason::poor_match;
  if (!is_held(finding.match, expected.covariance, options)) return ArcReason::degenerate;
  const bool expected_there =
      surprise(finding.match, expected) <= chi_squared_limit(GraphSpace::planar);
  return expected_there ? ArcReason::none : ArcReason::inconsistent;
}

}  // namespace

std::vector<LoopCandidate> loop_candidates(const std::vector<Keyframe>& keyframes,
                                           const std::vector<std::optional<UncertainPose>>& T_now,
                                           double min_doubt, const LoopOptions& options) {
  struct Visit {
    std::size_t keyframe;
    double distance;  // [m]
  };
  std::vector<Visit> visits;
  bool is_there = false;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (keyframes.back().travelled - keyframes[i].travelled < options.min_way) break;
    const bool was_there = is_there;
    is_there = T_now[i] && !keyframes[i].scan.ranges.empty() &&
               doubt_of(*T_now[i], options.map_way) >= min_doubt &&
               certain_distance(*T_now[i]) <= options.distance;
    if (!is_there) continue;
    const double distance = T_now[i]->mean.translation().norm();
    if (!was_there) visits.push_back({i, distance});
    if (distance < visits.back().distance) visits.back() = {i, distance};
  }
  std::stable_sort(visits.begin(), visits.end(),
                   [](const Visit& a, const Visit& b) { return a.distance < b.distance; });
  visits.resize(std::min(visits.size(), static_cast<std::size_t>(options.candidates)));
  std::vector<LoopCandidate> found;
  found.reserve(visits.size());
  for (const Visit& visit : visits) {
    found.push_back({visit.keyframe, inverse(*T_now[visit.keyframe])});
  }
  return found;
}

SearchWindow window_of(const UncertainPose& T_target_source, const LoopOptions& options) {
  const TangentMatrix& covariance = T_target_source.covariance;
  const double variance = largest_variance(covariance.topLeftCorner<2, 2>());
  return {std::min(options.max_reach, kSigmas * std::sqrt(variance)),
          std::min(options.max_turn, kSigmas * std::sqrt(covariance(5, 5)))};
}

Sighting locate(const LocalMap& target, const LocalMap& source, const UncertainPose& expected,
                const LoopOptions& options) {
  const SearchWindow window = window_of(expected, options);
  if (is_narrow(window)) return {expected.mean, ArcReason::none};
  const CorrelativeMatcher matcher(target.surface, window.reach, options.search);
  const auto found = matcher.search(source.surface, expected.mean, window);
  if (!found) return {expected.mean, ArcReason::low_overlap};
  const bool is_one_of_many = found->rival > options.max_rivalry * found->score;
  return {found->T_target_source, is_one_of_many ? ArcReason::ambiguous : ArcReason::none};
}

LoopFinding examine(const LocalMap& target, const LocalMap& source, const Pose& T_target_source,
                    const UncertainPose& expected, const LoopOptions& options,
                    const IcpOptions& icp_options) {
  LoopFinding finding;
  const SurfaceIndex index(target.surface);
  finding.match = icp(index, source.surface, T_target_source, GraphSpace::planar, icp_options);
  finding.agreement = agreement(target, source, finding.match.T_target_source, options.margin);
  finding.reason = judge(finding, expected, options);
  return finding;
}

}  // namespace portolan
