// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/restored_steps.hpp"

#include <stdexcept>
#include <string>

namespace portolan {

namespace {

[[noreturn]] void refuse(std::size_t pose, const std::string& why) {
  throw std::invalid_argument("pose " + std::to_string(pose) + " of the graph " + why);
}

}  // namespace

std::vector<RestoredStep> restored_steps(const Graph& graph) {
  const std::size_t count = graph.poses().size();
  std::vector<const Arc*> odometry(count, nullptr);
  std::vector<const Arc*> scan(count, nullptr);
  for (const Arc& arc : graph.arcs()) {
    const auto to = static_cast<std::size_t>(arc.to);
    if (arc.state != ArcState::accepted || arc.to != arc.from + 1 || to >= count) continue;
    if (arc.kind == ArcKind::odometry) odometry[to] = &arc;
    if (arc.kind == ArcKind::scan) scan[to] = &arc;
  }
  std::vector<RestoredStep> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (graph.poses()[i].id != static_cast<PoseId>(i)) refuse(i, "has another id");
    if (i == 0) continue;
    if (graph.poses()[i].stamp <= graph.poses()[i - 1].stamp) refuse(i, "is not later");
    if (odometry[i] == nullptr) refuse(i, "has no arc of odometry to it");
    steps[i].T_odometry = odometry[i]->T_from_to;
    steps[i].step = {odometry[i]->T_from_to,
                     covariance_of(odometry[i]->information, graph.space())};
    if (scan[i] != nullptr) steps[i].step = fused(*odometry[i], *scan[i], graph.space());
  }
  return steps;
}

}  // namespace portolan
