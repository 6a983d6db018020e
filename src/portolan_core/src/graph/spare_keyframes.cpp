// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/spare_keyframes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "portolan/correction.hpp"
#include "portolan/graph/neighbour_arcs.hpp"

namespace portolan {

namespace {

// The way before the newest keyframe that it is compared with, or that loops at it depend on [m].
double way_in_use(const PoseGraphOptions& options) {
  const LoopOptions& loops = options.loops;
  return std::max({options.scans.map_way, 2.0 * loops.map_way, loops.min_way,
                   loops.confirmation_reach, 2.0 * loops.places.confirmation_way});
}

std::size_t first_in_use(const std::vector<Keyframe>& keyframes, const PoseGraphOptions& options) {
  const double begin = keyframes.back().travelled - way_in_use(options);
  const auto is_before = [&](const Keyframe& keyframe) { return keyframe.travelled < begin; };
  return static_cast<std::size_t>(std::find_if_not(keyframes.begin(), keyframes.end(), is_before) -
                                  keyframes.begin());
}

// A step that says so little holds nothing, least of all the first keyframe, where the map is; over
// a gap it says nothing at all.
bool is_vague(const UncertainPose& step) {
  constexpr double kShift = 0.15;  // [m]
  constexpr double kTurn = 0.1;    // [rad]
  const auto variances = step.covariance.diagonal();
  return variances.head<2>().maxCoeff() > kShift * kShift || variances[5] > kTurn * kTurn;
}

// Loops go on to a neighbour, unless they are new; what somebody has said stays where it is.
std::vector<bool> held_by_arcs(const Graph& graph, std::size_t in_use) {
  std::vector<bool> is_held(graph.poses().size(), false);
  for (const Arc& arc : graph.arcs()) {
    const bool is_new = std::max(index_of(arc.from), index_of(arc.to)) >= in_use;
    const bool is_said = arc.kind != ArcKind::loop || arc.state == ArcState::disabled;
    if (is_between_neighbours(arc) || !(is_new || is_said)) continue;
    is_held[index_of(arc.from)] = is_held[index_of(arc.to)] = true;
  }
  return is_held;
}

// How many later keyframes stand in the same square metre and look the same way.
std::vector<int> seen_since(const PlacedKeyframes& placed) {
  constexpr double kSide = 1.0;  // [m]
  std::map<Square, int> seen;
  std::vector<int> since(placed.keyframes.size());
  for (std::size_t i = since.size(); i-- > 0;) {
    since[i] = seen[square_of(placed.T_map_base(i), kSide)]++;
  }
  return since;
}

// The step between the neighbours of keyframe i, in steps that make a keyframe due.
double step_without(std::size_t i, const std::vector<Keyframe>& keyframes,
                    const KeyframeOptions& options) {
  const auto turn = [&](std::size_t k) {
    return rotation_angle(keyframes[k - 1].T_odom_base.inverse() * keyframes[k].T_odom_base);
  };
  const double way = keyframes[i + 1].travelled - keyframes[i - 1].travelled;
  return way / options.min_travel + (turn(i) + turn(i + 1)) / options.min_turn;
}

// How far maps move that were drawn at keyframe i, when the correction passes over it [m].
double shift_without(std::size_t i, const PlacedKeyframes& placed) {
  const auto knot = [&](std::size_t k) {
    const Keyframe& keyframe = placed.keyframes[k];
    return Correction::Knot{keyframe.stamp, placed.T_map_base(k) * keyframe.T_odom_base.inverse()};
  };
  const Keyframe& keyframe = placed.keyframes[i];
  const Pose T_map_odom = Correction({knot(i - 1), knot(i + 1)}).at(keyframe.stamp);
  const Eigen::Vector3d p_map = (T_map_odom * keyframe.T_odom_base).translation();
  return (p_map - placed.T_map_base(i).translation()).norm();
}

}  // namespace

std::vector<std::size_t> spare_keyframes(const PlacedKeyframes& placed,
                                         const std::vector<UncertainPose>& steps, std::size_t most,
                                         const PoseGraphOptions& options) {
  const std::size_t in_use = first_in_use(placed.keyframes, options);
  const std::vector<bool> is_held = held_by_arcs(placed.graph, in_use);
  const std::vector<int> since = seen_since(placed);
  constexpr double kShift = 0.01;  // as bad as a step without any other keyframe at its place [m]
  std::vector<std::pair<double, std::size_t>> by_loss;
  for (std::size_t i = 1; i < in_use; ++i) {
    if (is_held[i] || is_vague(steps[i] * steps[i + 1])) continue;
    const double place = step_without(i, placed.keyframes, options.keyframes) / (1 + since[i]);
    const double loss = place + shift_without(i, placed) / kShift;
    if (std::isfinite(loss)) by_loss.emplace_back(loss, i);
  }
  std::sort(by_loss.begin(), by_loss.end());
  std::vector<std::size_t> spare;
  std::vector<bool> goes(placed.keyframes.size(), false);
  for (const auto& [loss, i] : by_loss) {
    if (spare.size() == most) break;
    if (goes[i - 1] || goes[i + 1]) continue;
    goes[i] = true;
    spare.push_back(i);
  }
  std::sort(spare.begin(), spare.end());
  return spare;
}

}  // namespace portolan
