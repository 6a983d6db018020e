// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "portolan/graph/loop/loop_arcs.hpp"
#include "portolan/graph/pose_graph.hpp"

namespace portolan {

namespace {

constexpr GraphSpace kSpace = GraphSpace::planar;

double chi_squared(const Arc& arc, const Graph& graph) {
  const Pose T = graph.at(arc.from).T_map_pose.inverse() * graph.at(arc.to).T_map_pose;
  const Tangent r = small_motion(arc.T_from_to.inverse() * T);
  return r.dot(arc.information * r);
}

}  // namespace

bool PoseGraph::is_near(const Pose& a, const Pose& b) {
  constexpr double kNear = 2.0;  // [m]
  constexpr double kTurn = 0.6;  // [rad]
  const Pose T = a.inverse() * b;
  return T.translation().norm() < kNear && rotation_angle(T) < kTurn;
}

// Whoever drives to and fro for hours must not pay for the same loops all the time: each costs an
// optimisation, and every map a redrawing.
bool PoseGraph::has_enough_loops(std::size_t here) const {
  const auto p_map = [&](std::size_t i) { return graph_.poses()[i].T_map_pose.translation(); };
  const auto is_here = [&](const Arc& arc) {
    return arc.kind == ArcKind::loop && arc.state == ArcState::accepted &&
           (p_map(index_of(arc.to)) - p_map(here)).norm() <= options_.loops.distance;
  };
  const auto found = std::count_if(graph_.arcs().begin(), graph_.arcs().end(), is_here);
  return found >= options_.loops.enough;
}

// Dead reckoning through the graph, with the graph's own coordinates for means.
std::vector<std::optional<UncertainPose>> PoseGraph::seen_from(std::size_t now) const {
  auto T_now = reckon(links(now + 1), now + 1, now);
  const Pose T_now_map = graph_.poses()[now].T_map_pose.inverse();
  for (std::size_t i = 0; i <= now; ++i) {
    if (T_now[i]) T_now[i]->mean = T_now_map * graph_.poses()[i].T_map_pose;
  }
  return T_now;
}

// The same if the robot is where a search has found a place for it: what lies before the gap is
// known by that arc, and by nothing else.
std::vector<std::optional<UncertainPose>> PoseGraph::seen_as_suspected(std::size_t now) const {
  const Arc& arc = graph_.arcs()[*suspected_];
  std::vector<Link> ways = links(now + 1);
  ways.push_back(link_of(arc));
  auto T_now = reckon(ways, now + 1, now);
  const Pose T_now_from = graph_.poses()[now].T_map_pose.inverse() * graph_.at(arc.to).T_map_pose *
                          arc.T_from_to.inverse();
  const Pose T_from_map = graph_.at(arc.from).T_map_pose.inverse();
  for (std::size_t i = 0; i < search_.begin(); ++i) {
    if (T_now[i]) T_now[i]->mean = T_now_from * T_from_map * graph_.poses()[i].T_map_pose;
  }
  for (std::size_t i = search_.begin(); i <= now; ++i) T_now[i].reset();
  return T_now;
}

// Where nobody knows how the robot came here, places before the gap are nowhere.
void PoseGraph::look_for_loops() {
  const std::size_t now = keyframes_.size() - 1;
  if (keyframes_[now].travelled - looked_ < options_.loops.every) return;
  looked_ = keyframes_[now].travelled;
  auto T_now = seen_from(now);
  const bool is_lost = this->is_lost();
  const bool is_open = is_lost && is_searched_;
  if (is_open && !has_guess_) {
    for (std::size_t i = 0; i < search_.begin(); ++i) T_now[i].reset();
  }
  compare_visits(T_now, options_);
  if (is_lost && suspected_) compare_visits(seen_as_suspected(now), strict());
}

void PoseGraph::compare_visits(const std::vector<std::optional<UncertainPose>>& T_now,
                               const PoseGraphOptions& options) {
  const std::size_t now = keyframes_.size() - 1;
  const double min_doubt = has_enough_loops(now) ? options.loops.min_doubt : 0.0;
  for (const LoopCandidate& candidate :
       loop_candidates(keyframes_, T_now, min_doubt, options.loops)) {
    take(loop_arc(placed(), candidate, now, options), options);
  }
}

void PoseGraph::take(const Arc& loop, const PoseGraphOptions& options) {
  const std::size_t arc = graph_.add(loop);
  if (!is_first_round()) confirm(arc, options);
}

// Loops that a guess has led to wait until the search has compared all places once.
bool PoseGraph::is_first_round() const {
  return is_searched_ && search_.rounds() == 0 && is_lost();
}

void PoseGraph::confirm(std::size_t arc, const PoseGraphOptions& options) {
  const auto confirmed = confirmation(placed(), chain_, arc, options.loops);
  if (!confirmed.empty()) accept(confirmed);
}

// What is asked of loops where nothing but scans says where the robot is.
PoseGraphOptions PoseGraph::strict() const {
  PoseGraphOptions options = options_;
  options.loops.min_agreed = options.loops.places.min_agreed;
  options.loops.confirmation_way = options.loops.places.confirmation_way;
  return options;
}

bool PoseGraph::is_lost() const {
  const auto holds = [&](const Arc& arc) {
    const auto [first, last] = std::minmax({index_of(arc.from), index_of(arc.to)});
    const bool is_guess = arc.kind == ArcKind::given && last == first + 1;
    return closes(arc) && !is_guess && first < search_.begin() && last >= search_.begin();
  };
  return search_.begin() > 0 && std::none_of(graph_.arcs().begin(), graph_.arcs().end(), holds);
}

void PoseGraph::look_everywhere() {
  const double here = keyframes_.back().travelled;
  const double patience = 2.0 * options_.loops.places.confirmation_way;
  if (suspected_ &&
      here - keyframes_[index_of(graph_.arcs()[*suspected_].to)].travelled > patience) {
    suspected_.reset();
  }
  const bool was_first = is_first_round();
  const auto loop = search_.go_on(placed(), options_);
  if (!loop) {
    if (was_first && !is_first_round()) confirm_guess();
    return;
  }
  suspected_ = graph_.arcs().size();
  const Pose T_map_here = graph_.at(loop->from).T_map_pose * loop->T_from_to;
  has_guess_ = has_guess_ && is_near(T_map_here, graph_.at(loop->to).T_map_pose);
  take(*loop, strict());
  if (was_first && has_guess_) confirm_guess();
}

void PoseGraph::confirm_guess() {
  for (std::size_t i = graph_.arcs().size(); i > 0 && is_lost(); --i) {
    const Arc& arc = graph_.arcs()[i - 1];
    if (index_of(arc.to) < search_.begin()) return;
    const bool is_loop = arc.kind == ArcKind::loop && arc.reason == ArcReason::unconfirmed;
    if (is_loop) confirm(i - 1, options_);
  }
}

void PoseGraph::accept(const std::vector<std::size_t>& arcs) {
  std::vector<std::size_t> fresh;
  for (const std::size_t i : arcs) {
    if (graph_.arcs()[i].state == ArcState::accepted) continue;
    graph_.set_state(i, ArcState::accepted, ArcReason::none);
    fresh.push_back(i);
  }
  settle();
  if (!is_lost()) suspected_.reset();
  const auto torn = [&](const Arc& arc) {
    return arc.kind == ArcKind::loop && arc.state == ArcState::accepted &&
           chi_squared(arc, graph_) > 2.0 * chi_squared_limit(kSpace);
  };
  if (std::none_of(graph_.arcs().begin(), graph_.arcs().end(), torn)) return;
  for (const std::size_t i : fresh) {
    graph_.set_state(i, ArcState::rejected, ArcReason::inconsistent);
  }
  settle();
}

}  // namespace portolan
