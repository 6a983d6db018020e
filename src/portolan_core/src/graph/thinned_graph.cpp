// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/thinned_graph.hpp"

#include <optional>
#include <set>
#include <utility>

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/loop/loop_arcs.hpp"
#include "portolan/graph/neighbour_arcs.hpp"

namespace portolan {

namespace {

// What arcs say of each keyframe.
struct Bonds {
  Bonds(const Graph& graph, const std::vector<UncertainPose>& steps)
      : odometry(steps.size(), nullptr), has_scan(steps.size(), false), part(steps.size(), 0) {
    for (std::size_t i = 1; i < steps.size(); ++i)
      part[i] = part[i - 1] + (is_gap(steps[i]) ? 1 : 0);
    for (const Arc& arc : graph.arcs()) {
      if (arc.state != ArcState::accepted) continue;
      const std::size_t to = index_of(arc.to);
      if (!is_between_neighbours(arc)) {
        tied.insert({to, part[index_of(arc.from)]});
      } else if (arc.kind == ArcKind::odometry) {
        odometry[to] = &arc;
      } else {
        has_scan[to] = true;
      }
    }
  }

  std::vector<const Arc*> odometry;            // from the one before
  std::vector<bool> has_scan;                  // with which it counts
  std::vector<int> part;                       // of the way, by gaps
  std::set<std::pair<std::size_t, int>> tied;  // to a part, by a loop that ends there
};

class Thinner {
 public:
  Thinner(const Graph& graph, const std::vector<UncertainPose>& steps,
          const std::vector<std::size_t>& spare)
      : graph_(graph),
        steps_(steps),
        bonds_(graph, steps),
        goes_(steps.size(), false),
        left_{Graph(graph.space()), {}, {}} {
    for (const std::size_t i : spare) goes_[i] = true;
  }

  ThinnedGraph thin() {
    for (std::size_t i = 0; i < goes_.size(); ++i) add_pose(i);
    for (std::size_t i = 0; i < graph_.arcs().size(); ++i) add_arc(i);
    return std::move(left_);
  }

 private:
  bool is_bridged(std::size_t i) const { return i > 0 && goes_[i - 1]; }

  void add_pose(std::size_t i) {
    names_.push_back(static_cast<PoseId>(left_.steps.size()));
    if (goes_[i]) return;
    GraphPose pose = graph_.poses()[i];
    pose.id = names_.back();
    left_.graph.add(pose);
    left_.steps.push_back(is_bridged(i) ? steps_[i - 1] * steps_[i] : steps_[i]);
  }

  // Where an arc of odometry came to a keyframe, that over the one that went comes now.
  void add_arc(std::size_t i) {
    const Arc& arc = graph_.arcs()[i];
    const std::size_t from = index_of(arc.from);
    const std::size_t to = index_of(arc.to);
    if (!is_between_neighbours(arc)) {
      if (const auto carried = carry(arc)) add(*carried, i);
    } else if (!goes_[to] && !goes_[from]) {
      add(arc, i);
    } else if (!goes_[to] && bonds_.odometry[to] == &arc) {
      bridge(to, i);
    }
  }

  void bridge(std::size_t to, std::size_t was) {
    const Pose T = bonds_.odometry[to - 1]->T_from_to * bonds_.odometry[to]->T_from_to;
    const bool has_scan = bonds_.has_scan[to - 1] || bonds_.has_scan[to];
    auto [odometry, scan] = neighbour_arcs(T, left_.steps[index_of(names_[to])], has_scan);
    for (Arc* arc : {&odometry, scan ? &*scan : nullptr}) {
      if (arc == nullptr) continue;
      arc->from = static_cast<PoseId>(to - 2);
      arc->to = static_cast<PoseId>(to);
      add(*arc, was);
    }
  }

  // A loop goes on to the keyframe before the one that went, where its residual is what it was; not
  // if it only told of the later end, and another one does so there.
  std::optional<Arc> carry(Arc arc) const {
    const std::size_t from = index_of(arc.from);
    const std::size_t to = index_of(arc.to);
    if (!goes_[from] && !goes_[to]) return arc;
    if (arc.state != ArcState::accepted) return std::nullopt;
    if (goes_[to] && bonds_.tied.count({to - 1, bonds_.part[from]}) > 0) return std::nullopt;
    UncertainPose T = link_of(arc).T_from_to;
    if (goes_[from]) T = step_to(from) * T;
    if (goes_[to]) T = T * inverse(step_to(to));
    arc.from -= goes_[from] ? 1 : 0;
    arc.to -= goes_[to] ? 1 : 0;
    if (arc.from == arc.to) return std::nullopt;
    arc.T_from_to = T.mean;
    arc.information = information_of(T.covariance, graph_.space());
    return arc;
  }

  // From the one before, by the graph's coordinates.
  UncertainPose step_to(std::size_t i) const {
    const auto& poses = graph_.poses();
    return {poses[i - 1].T_map_pose.inverse() * poses[i].T_map_pose, steps_[i].covariance};
  }

  void add(Arc arc, std::size_t was) {
    arc.from = names_[index_of(arc.from)];
    arc.to = names_[index_of(arc.to)];
    left_.graph.add(arc);
    left_.arcs.push_back(was);
  }

  const Graph& graph_;
  const std::vector<UncertainPose>& steps_;
  Bonds bonds_;
  std::vector<bool> goes_;
  std::vector<PoseId> names_;  // new ones by old ones
  ThinnedGraph left_;
};

}  // namespace

ThinnedGraph thinned(const Graph& graph, const std::vector<UncertainPose>& steps,
                     const std::vector<std::size_t>& spare) {
  return Thinner(graph, steps, spare).thin();
}

}  // namespace portolan
