// SPDX-License-Identifier: BSD-3-Clause
#include "beacon_bag.hpp"

#include <portolan_msgs/BeaconRanges.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>

namespace portolan::bench {

namespace {

constexpr double kAll = 1e7;  // seconds that tf remembers

void read_tf(const rosbag::Bag& bag, tf2::BufferCore& tf) {
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
    if (!transforms) continue;
    const bool is_static = message.getTopic().find("static") != std::string::npos;
    for (const auto& transform : transforms->transforms) {
      tf.setTransform(transform, "bag", is_static);
    }
  }
}

Pose pose(const geometry_msgs::Transform& from) {
  Pose to(Eigen::Quaterniond(from.rotation.w, from.rotation.x, from.rotation.y, from.rotation.z));
  to.translation() = Eigen::Vector3d(from.translation.x, from.translation.y, from.translation.z);
  return to;
}

}  // namespace

BeaconWorkload beacon_bag(const std::string& path) {
  const rosbag::Bag bag(path);
  tf2::BufferCore tf{ros::Duration(kAll)};
  read_tf(bag, tf);
  BeaconWorkload load;
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const auto heard = message.instantiate<portolan_msgs::BeaconRanges>();
    if (!heard) continue;
    const std_msgs::Header& header = heard->header;
    if (!tf.canTransform("odom", header.frame_id, header.stamp)) continue;
    BeaconWorkload::PosedRanges posed;
    posed.T_map_sensor = pose(tf.lookupTransform("odom", header.frame_id, header.stamp).transform);
    for (const auto& range : heard->ranges) {
      posed.z.ranges.push_back({range.id, range.range, range.stddev});
    }
    load.posed.push_back(posed);
  }
  if (load.posed.empty()) throw std::runtime_error(path + ": holds no ranges that tf can pose");
  return load;
}

}  // namespace portolan::bench
