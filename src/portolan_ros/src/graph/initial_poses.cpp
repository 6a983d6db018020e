// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/initial_poses.hpp"

#include <algorithm>
#include <optional>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/pose_graph.hpp"

namespace portolan {

namespace {

InitialPoseFate fate_of(const geometry_msgs::PoseWithCovarianceStamped& message,
                        const std::string& map_frame, Time now, PoseGraph& graph) {
  using ros_convert::without_slash;
  if (without_slash(message.header.frame_id) != without_slash(map_frame)) {
    return InitialPoseFate::other_frame;
  }
  const std::optional<UncertainPose> T_map_base = ros_convert::guess(message.pose);
  if (!T_map_base) return InitialPoseFate::malformed;
  const Time since = std::min(now, ros_convert::time(message.header.stamp));
  switch (graph.expect(*T_map_base, since)) {
    case Outcome::inserted:
      return InitialPoseFate::used;
    case Outcome::rejected:
      return InitialPoseFate::no_map;
    case Outcome::unusable:
      break;
  }
  return InitialPoseFate::malformed;
}

}  // namespace

void InitialPoses::receive(const geometry_msgs::PoseWithCovarianceStamped& message, Time now,
                           PoseGraph& graph) {
  ++counts_.at(static_cast<std::size_t>(fate_of(message, map_frame_, now, graph)));
}

}  // namespace portolan
