// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "portolan/graph/pose_graph.hpp"
#include "portolan/graph/restored_steps.hpp"
#include "portolan/graph/scan_file.hpp"

namespace portolan {

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
    restored.step_on(steps[i].step);
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

}  // namespace portolan
