// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "portolan/graph/graph_optimizer.hpp"
#include "portolan/graph/loop/loop_arcs.hpp"
#include "portolan/graph/neighbour_arcs.hpp"
#include "portolan/graph/restored_steps.hpp"
#include "portolan/graph/scan_file.hpp"

namespace portolan {

namespace {

constexpr GraphSpace kSpace = GraphSpace::planar;

std::size_t index_of(PoseId id) { return static_cast<std::size_t>(id); }

double chi_squared(const Arc& arc, const Graph& graph) {
  const Pose T = graph.at(arc.from).T_map_pose.inverse() * graph.at(arc.to).T_map_pose;
  const Tangent r = small_motion(arc.T_from_to.inverse() * T);
  return r.dot(arc.information * r);
}

}  // namespace

PoseGraph::PoseGraph(const Options& options)
    : options_(checked(options)), graph_(kSpace), chain_(kSpace) {}

std::optional<Outcome> PoseGraph::insert(Time stamp, const Pose& T_odom_base, const RangeScan& scan,
                                         const Pose& T_base_sensor) {
  if (!is_usable(scan) || !is_valid(T_odom_base) || !is_valid(T_base_sensor)) {
    return Outcome::unusable;
  }
  const bool is_first = keyframes_.empty();
  if (!is_first && stamp <= keyframes_.back().stamp) return Outcome::rejected;
  if (!is_first && !is_due(stamp, T_odom_base)) return std::nullopt;
  if (keyframes_.size() == static_cast<std::size_t>(options_.keyframes.max_count)) {
    return Outcome::rejected;
  }
  const double travelled = is_first ? 0.0 : way_to(T_odom_base);
  keyframes_.push_back({stamp, T_odom_base, T_base_sensor, scan, travelled});
  const auto id = static_cast<PoseId>(keyframes_.size() - 1);
  graph_.add(GraphPose{id, stamp, T_odom_base, is_first});
  if (is_first) {
    steps_.emplace_back();
    chain_.add(steps_.back());
  } else {
    connect();
    if (options_.loops.enabled) look_for_loops();
  }
  scan_bytes_ += byte_size(keyframes_.back().scan);
  forget_scans();
  return Outcome::inserted;
}

double PoseGraph::way_to(const Pose& T_odom_base) const {
  const Keyframe& last = keyframes_.back();
  return last.travelled + (last.T_odom_base.translation() - T_odom_base.translation()).norm();
}

bool PoseGraph::is_due(Time stamp, const Pose& T_odom_base) const {
  const KeyframeOptions& options = options_.keyframes;
  const Pose moved = keyframes_.back().T_odom_base.inverse() * T_odom_base;
  const double share = std::max(moved.translation().norm() / options.min_travel,
                                rotation_angle(moved) / options.min_turn);
  const bool waited = options.min_interval > 0.0 &&
                      to_seconds(stamp - keyframes_.back().stamp) >= options.min_interval;
  return share >= 1.0 || (waited && share >= 0.1);
}

void PoseGraph::connect() {
  const std::size_t now = keyframes_.size() - 1;
  const LocalMap around_last =
      options_.scans.enabled
          ? placed().map_around(now - 1, options_.scans.map_way, 0.0, options_.surfaces)
          : LocalMap{};
  const auto add = [&](Arc& arc) {
    arc.from = static_cast<PoseId>(now - 1);
    arc.to = static_cast<PoseId>(now);
    graph_.add(arc);
  };
  auto [odometry, scan] =
      neighbour_arcs(keyframes_[now - 1], keyframes_[now], around_last, options_, is_resumed_);
  is_resumed_ = false;
  add(odometry);
  if (scan) add(*scan);
  const bool counts = scan && scan->state == ArcState::accepted;
  steps_.push_back(counts ? fused(odometry, *scan, kSpace) : link_of(odometry).T_from_to);
  chain_.add(steps_.back());
  place_after(now - 1);
}

void PoseGraph::forget_scans() {
  const double budget = options_.keyframes.scan_budget * 1e6;
  while (static_cast<double>(scan_bytes_) > budget && forgotten_ + 1 < keyframes_.size()) {
    RangeScan& oldest = keyframes_[forgotten_].scan;
    scan_bytes_ -= byte_size(oldest);
    oldest = RangeScan{};
    ++forgotten_;
  }
}

std::vector<Link> PoseGraph::links(std::size_t count) const {
  std::vector<Link> all;
  for (std::size_t i = 1; i < count; ++i) all.push_back({i - 1, i, steps_[i]});
  for (const Arc& arc : graph_.arcs()) {
    const bool inside = std::max(index_of(arc.from), index_of(arc.to)) < count;
    if (closes(arc) && inside) all.push_back(link_of(arc));
  }
  return all;
}

bool PoseGraph::closes(const Arc& arc) const {
  return arc.state == ArcState::accepted &&
         (arc.kind == ArcKind::loop || arc.kind == ArcKind::given);
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

void PoseGraph::look_for_loops() {
  const std::size_t now = keyframes_.size() - 1;
  if (keyframes_[now].travelled - looked_ < options_.loops.every) return;
  looked_ = keyframes_[now].travelled;
  auto T_now = reckon(links(now + 1), now + 1, now);
  const Pose T_now_map = graph_.poses()[now].T_map_pose.inverse();
  for (std::size_t i = 0; i <= now; ++i) {
    if (T_now[i]) T_now[i]->mean = T_now_map * graph_.poses()[i].T_map_pose;
  }
  const double min_doubt = has_enough_loops(now) ? options_.loops.min_doubt : 0.0;
  for (const LoopCandidate& candidate :
       loop_candidates(keyframes_, T_now, min_doubt, options_.loops)) {
    const std::size_t arc = graph_.add(loop_arc(placed(), candidate, now, options_));
    const auto confirmed = confirmation(placed(), chain_, arc, options_.loops);
    if (!confirmed.empty()) accept(confirmed);
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

void PoseGraph::settle() {
  ++generation_;
  report_.reset();
  std::size_t last = 0;
  for (const Arc& arc : graph_.arcs()) {
    if (closes(arc)) last = std::max({last, index_of(arc.from), index_of(arc.to)});
  }
  if (last > 0) {
    const auto T_first = reckon(links(last + 1), last + 1, 0);
    Graph part(kSpace);
    const Pose T_map_first = keyframes_.front().T_odom_base;
    for (std::size_t i = 0; i <= last; ++i) {
      GraphPose pose = graph_.poses()[i];
      pose.T_map_pose = T_map_first * T_first[i]->mean;
      part.add(pose);
    }
    for (const Arc& arc : graph_.arcs()) {
      const bool inside = std::max(index_of(arc.from), index_of(arc.to)) <= last;
      if (inside && arc.state == ArcState::accepted) part.add(arc);
    }
    report_ = GraphOptimizer(options_.optimizer).optimize(part);
    for (std::size_t i = 0; i <= last; ++i) graph_.move(i, part.poses()[i].T_map_pose);
  }
  place_after(last);
}

void PoseGraph::place_after(std::size_t keyframe) {
  for (std::size_t i = keyframe + 1; i < keyframes_.size(); ++i) {
    graph_.move(i, graph_.poses()[i - 1].T_map_pose * steps_[i].mean);
  }
}

std::size_t PoseGraph::add(PoseId from, PoseId to, const Pose& T_from_to,
                           const TangentMatrix& information, bool force) {
  Arc arc;
  arc.from = from;
  arc.to = to;
  arc.T_from_to = T_from_to;
  arc.information = information;
  arc.kind = ArcKind::given;
  arc.reason = ArcReason::by_request;
  const std::size_t index = graph_.add(arc);
  if (graph_.arcs()[index].state != ArcState::accepted) return index;
  const auto T_from = reckon(links(keyframes_.size()), keyframes_.size(), index_of(from));
  const TangentMatrix of_way = T_from[index_of(to)]->covariance;
  const ArcReason fault = force ? ArcReason::none : fault_of(placed(), arc, of_way, options_);
  if (fault != ArcReason::none) {
    graph_.set_state(index, ArcState::rejected, fault);
    return index;
  }
  settle();
  return index;
}

void PoseGraph::disable(std::size_t arc) { change(arc, ArcState::disabled); }

void PoseGraph::enable(std::size_t arc) {
  if (graph_.arcs().at(arc).reason == ArcReason::bad_information) {
    throw std::invalid_argument("arc " + std::to_string(arc) + " has no information");
  }
  change(arc, ArcState::accepted);
}

void PoseGraph::change(std::size_t arc, ArcState state) {
  const Arc& changed = graph_.arcs().at(arc);
  if (changed.kind != ArcKind::loop && changed.kind != ArcKind::given) {
    throw std::invalid_argument("arc " + std::to_string(arc) + " holds neighbours together");
  }
  const bool counted = changed.state == ArcState::accepted;
  graph_.set_state(arc, state, ArcReason::by_request);
  if (counted != (state == ArcState::accepted)) settle();
}

PoseGraph PoseGraph::restored(const Options& options, const Graph& graph) {
  PoseGraph restored(options);
  restored.graph_ = graph;
  const std::vector<RestoredStep> steps = restored_steps(graph);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Keyframe keyframe;
    keyframe.stamp = graph.poses()[i].stamp;
    keyframe.T_odom_base = i == 0 ? graph.poses()[0].T_map_pose
                                  : restored.keyframes_.back().T_odom_base * steps[i].T_odometry;
    if (i > 0) keyframe.travelled = restored.way_to(keyframe.T_odom_base);
    restored.keyframes_.push_back(keyframe);
    restored.steps_.push_back(steps[i].step);
    restored.chain_.add(steps[i].step);
  }
  restored.forgotten_ = steps.size();
  restored.is_resumed_ = true;
  if (!steps.empty()) restored.settle();
  return restored;
}

void PoseGraph::recall(std::vector<SavedScan> scans) {
  for (SavedScan& saved : scans) {
    const std::optional<std::size_t> place = graph_.find(saved.keyframe);
    if (!place || keyframes_[*place].stamp != saved.stamp) {
      throw std::invalid_argument("there is no keyframe " + std::to_string(saved.keyframe) +
                                  " of the scan's time");
    }
    keyframes_[*place].T_base_sensor = saved.T_base_sensor;
    keyframes_[*place].scan = std::move(saved.scan);
  }
  const auto has_scan = [](const Keyframe& keyframe) { return !keyframe.scan.ranges.empty(); };
  const auto first = std::find_if(keyframes_.begin(), keyframes_.end(), has_scan);
  forgotten_ = static_cast<std::size_t>(first - keyframes_.begin());
  scan_bytes_ = std::accumulate(
      first, keyframes_.end(), std::size_t{0},
      [](std::size_t sum, const Keyframe& keyframe) { return sum + byte_size(keyframe.scan); });
  forget_scans();
}

Correction PoseGraph::correction() const {
  std::vector<Correction::Knot> knots;
  knots.reserve(keyframes_.size());
  for (std::size_t i = 0; i < keyframes_.size(); ++i) {
    const Pose& T_map_base = graph_.poses()[i].T_map_pose;
    knots.push_back({keyframes_[i].stamp, T_map_base * keyframes_[i].T_odom_base.inverse()});
  }
  return Correction(std::move(knots));
}

}  // namespace portolan
