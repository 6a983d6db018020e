// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/drift_tf.hpp"

#include <tf2_msgs/TFMessage.h>

#include <utility>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

constexpr double kPeriod = 0.05;  // [s]

}  // namespace

DriftTf::DriftTf(std::string map_frame, std::string odom_frame)
    : map_frame_(std::move(map_frame)), odom_frame_(std::move(odom_frame)) {
  handle_.setCallbackQueue(&queue_);
  tf_ = handle_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  timer_ = handle_.createWallTimer(ros::WallDuration(kPeriod),
                                   [this](const ros::WallTimerEvent& /*event*/) { send(); });
  spinner_.start();
}

void DriftTf::set(const Pose& T_map_odom) {
  const std::lock_guard<std::mutex> lock(mutex_);
  T_map_odom_ = T_map_odom;
}

void DriftTf::send() {
  const ros::Time stamp = ros::Time::now();
  if (stamp.isZero() || stamp == sent_) return;
  sent_ = stamp;
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.stamp = stamp;
  message.transforms[0].header.frame_id = map_frame_;
  message.transforms[0].child_frame_id = odom_frame_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    message.transforms[0].transform = ros_convert::transform(T_map_odom_);
  }
  tf_.publish(message);
}

}  // namespace portolan
