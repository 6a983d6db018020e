// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "portolan/graph/pose_graph.hpp"
#include "portolan/graph/spare_keyframes.hpp"
#include "portolan/graph/thinned_graph.hpp"

namespace portolan {

namespace {

std::size_t rejected_loops(const Graph& graph) {
  const auto is_one = [](const Arc& arc) {
    return arc.kind == ArcKind::loop && arc.state == ArcState::rejected;
  };
  return static_cast<std::size_t>(std::count_if(graph.arcs().begin(), graph.arcs().end(), is_one));
}

}  // namespace

// A quarter of the keyframes at a time: each time costs an optimisation, and every map a redrawing.
bool PoseGraph::make_room() {
  const auto max_count = static_cast<std::size_t>(options_.keyframes.max_count);
  while (keyframes_.size() >= max_count) {
    const std::size_t most = keyframes_.size() - 3 * max_count / 4;
    const auto spare = spare_keyframes(placed(), steps_, most, options_);
    constexpr std::size_t kWorthIt = 100;  // part of all
    if (spare.size() * kWorthIt < max_count) return false;
    drop(spare);
  }
  return true;
}

void PoseGraph::drop(const std::vector<std::size_t>& spare) {
  const auto renumbered = [&](std::size_t i) {
    const auto gone = std::lower_bound(spare.begin(), spare.end(), i) - spare.begin();
    return i - static_cast<std::size_t>(gone);
  };
  ThinnedGraph left = thinned(graph_, steps_, spare);
  dropped_ += spare.size();
  dropped_loops_ += rejected_loops(graph_) - rejected_loops(left.graph);
  graph_ = std::move(left.graph);
  steps_ = std::move(left.steps);
  chain_ = Chain(graph_.space());
  for (const UncertainPose& step : steps_) chain_.add(step);
  drop_keyframes(spare);
  forgotten_ = renumbered(forgotten_);
  search_.restart(renumbered(search_.begin()));
  if (suspected_) {
    const auto arc = std::find(left.arcs.begin(), left.arcs.end(), *suspected_);
    suspected_ = static_cast<std::size_t>(arc - left.arcs.begin());
  }
  settle();
}

void PoseGraph::drop_keyframes(const std::vector<std::size_t>& spare) {
  std::vector<Keyframe> left;
  left.reserve(keyframes_.size() - spare.size());
  auto next = spare.begin();
  for (std::size_t i = 0; i < keyframes_.size(); ++i) {
    if (next == spare.end() || i != *next) {
      left.push_back(std::move(keyframes_[i]));
      continue;
    }
    if (i >= forgotten_) scan_bytes_ -= byte_size(keyframes_[i].scan);
    ++next;
  }
  keyframes_ = std::move(left);
}

}  // namespace portolan
