// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/correction.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "portolan_ros/convert/basics.hpp"

namespace portolan::ros_convert {

namespace {

void check_frame(const std::string& name, const std::string& expected, const std::string& what) {
  if (without_slash(name) != without_slash(expected)) {
    throw std::invalid_argument("its " + what + " is \"" + name + "\", not \"" + expected + "\"");
  }
}

}  // namespace

Correction correction(const portolan_msgs::DriftCorrection& message, const std::string& map_frame,
                      const std::string& odom_frame) {
  check_frame(message.child_frame_id, odom_frame, "odometry frame");
  if (!message.header.frame_id.empty())
    check_frame(message.header.frame_id, map_frame, "map frame");
  if (message.stamps.size() != message.poses.size()) {
    throw std::invalid_argument("a correction needs as many poses as stamps");
  }
  std::vector<Correction::Knot> knots;
  knots.reserve(message.stamps.size());
  for (std::size_t i = 0; i < message.stamps.size(); ++i) {
    knots.push_back({time(message.stamps[i]), pose(message.poses[i])});
  }
  return Correction(std::move(knots));
}

portolan_msgs::DriftCorrection correction(const Correction& correction,
                                          const std::string& map_frame,
                                          const std::string& odom_frame) {
  portolan_msgs::DriftCorrection message;
  message.header.frame_id = map_frame;
  message.child_frame_id = odom_frame;
  for (const Correction::Knot& knot : correction.knots()) {
    message.stamps.push_back(time(knot.stamp));
    message.poses.push_back(pose(knot.T_map_odom));
  }
  return message;
}

}  // namespace portolan::ros_convert
