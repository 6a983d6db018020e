// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "portolan/graph/pose_graph.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// What became of a pose that somebody gave the robot.
enum class InitialPoseFate {
  used,
  other_frame,  ///< it is not in the map's frame
  malformed,    ///< it is no pose, or its covariance is none
  no_map,       ///< there is no keyframe yet: the map begins where odometry does
};

constexpr std::array<const char*, 4> enum_names(InitialPoseFate) {
  return {"used", "other_frame", "malformed", "no_map"};
}

/// Lets somebody say where the robot is, as with rviz's "2D Pose Estimate", and counts what became
/// of it.
class InitialPoses {
 public:
  explicit InitialPoses(std::string map_frame) : map_frame_(std::move(map_frame)) {}

  /// The pose counts for the first scan that is not older. A stamp that is not yet means now.
  void receive(const geometry_msgs::PoseWithCovarianceStamped& message, Time now, PoseGraph& graph);

  std::size_t count(InitialPoseFate fate) const {
    return counts_.at(static_cast<std::size_t>(fate));
  }

 private:
  std::string map_frame_;
  std::array<std::size_t, enum_names(InitialPoseFate{}).size()> counts_{};
};

}  // namespace portolan
