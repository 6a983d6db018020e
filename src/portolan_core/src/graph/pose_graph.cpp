// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/pose_graph.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "portolan/graph/graph_optimizer.hpp"
#include "portolan/graph/loop/loop_arcs.hpp"
#include "portolan/graph/neighbour_arcs.hpp"
#include "portolan/pose_covariance.hpp"

namespace portolan {

namespace {

constexpr GraphSpace kSpace = GraphSpace::planar;

// What is said by hand is never surer than this [m^2, rad^2].
constexpr double kLeastVariance = 0.25 * 0.25;
constexpr double kLeastTurnVariance = 0.1 * 0.1;

// What is left of odometry's information where somebody knows better.
constexpr double kNothing = 1e-6;

// Keyframes on both sides of a gap are no neighbours, however near odometry puts them [m].
constexpr double kGap = 1e3;

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
  if (!make_room()) return Outcome::rejected;
  const double travelled = is_first ? 0.0 : way_to(T_odom_base);
  keyframes_.push_back({stamp, T_odom_base, T_base_sensor, scan, travelled});
  const auto id = static_cast<PoseId>(keyframes_.size() - 1);
  graph_.add(GraphPose{id, stamp, T_odom_base, is_first});
  if (is_first) {
    step_on({});
  } else {
    connect();
    if (options_.loops.enabled) look_for_loops();
    if (options_.loops.enabled && is_searched_ && is_lost()) look_everywhere();
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
  if (is_told(stamp)) return true;
  const KeyframeOptions& options = options_.keyframes;
  const Pose moved = keyframes_.back().T_odom_base.inverse() * T_odom_base;
  const double share = std::max(moved.translation().norm() / options.min_travel,
                                rotation_angle(moved) / options.min_turn);
  const bool waited = options.min_interval > 0.0 &&
                      to_seconds(stamp - keyframes_.back().stamp) >= options.min_interval;
  return share >= 1.0 || (waited && share >= 0.1);
}

Outcome PoseGraph::expect(const UncertainPose& T_map_base, Time since) {
  if (!is_valid(T_map_base.mean) || !is_stated(T_map_base.covariance)) return Outcome::unusable;
  if (keyframes_.empty()) return Outcome::rejected;
  told_ = T_map_base;
  told_since_ = since;
  return Outcome::inserted;
}

// A node that was started again in mid-run goes on with the same odometry, which has hardly moved.
// Where somebody said where the robot is, it is not matched with where it was: loops decide.
void PoseGraph::connect() {
  const std::size_t now = keyframes_.size() - 1;
  const bool is_told = this->is_told(keyframes_[now].stamp);
  const LocalMap around_last =
      options_.scans.enabled && !is_told
          ? placed().map_around(now - 1, options_.scans.map_way, 0.0, options_.surfaces)
          : LocalMap{};
  const auto add = [&](Arc& arc) {
    arc.from = static_cast<PoseId>(now - 1);
    arc.to = static_cast<PoseId>(now);
    graph_.add(arc);
  };
  auto [odometry, scan] = neighbour_arcs(keyframes_[now - 1], keyframes_[now], around_last,
                                         options_, is_resumed_ || is_told);
  is_resumed_ = false;
  if (is_told) odometry.information *= kNothing;
  add(odometry);
  if (scan) add(*scan);
  const bool counts = scan && scan->state == ArcState::accepted;
  step_on(counts ? fused(odometry, *scan, kSpace) : link_of(odometry).T_from_to);
  if (is_gap(steps_.back())) {
    search_ = PlaceSearch(now);
    suspected_.reset();
    has_guess_ =
        counts || is_told || is_near(keyframes_[now - 1].T_odom_base, keyframes_[now].T_odom_base);
    is_searched_ = options_.loops.places.enabled && !is_told;
  }
  place_after(now - 1);
  if (!is_told) return;
  add_guess(told_->mean, told_->covariance);
  told_.reset();
}

void PoseGraph::step_on(const UncertainPose& step) {
  if (is_gap(step)) keyframes_[steps_.size()].travelled += kGap;
  steps_.push_back(step);
  chain_.add(step);
}

void PoseGraph::add_guess(const Pose& T_map_base, const TangentMatrix& covariance) {
  const std::size_t now = keyframes_.size() - 1;
  TangentMatrix least = TangentMatrix::Zero();
  least.diagonal() << kLeastVariance, kLeastVariance, 0.0, 0.0, 0.0, kLeastTurnVariance;
  Arc guess;
  guess.from = static_cast<PoseId>(now - 1);
  guess.to = static_cast<PoseId>(now);
  const Pose T = graph_.poses()[now - 1].T_map_pose.inverse() * T_map_base;
  guess.T_from_to = planar_pose(T.translation().x(), T.translation().y(), yaw(T));
  guess.information = information_of(covariance + least, kSpace);
  guess.kind = ArcKind::given;
  guess.reason = ArcReason::by_request;
  graph_.add(guess);
  settle();
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
