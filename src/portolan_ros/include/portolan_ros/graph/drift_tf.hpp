// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/time.h>
#include <ros/wall_timer.h>

#include <mutex>
#include <string>

#include "portolan/pose.hpp"

namespace portolan {

/// Says on tf where odometry lies in the map, twenty times a second and from a thread of its own:
/// a robot that drives by it must not wait while a large graph is solved or saved.
///
/// While the clock stands still nothing is sent, since tf knows one transform for each stamp.
class DriftTf {
 public:
  DriftTf(std::string map_frame, std::string odom_frame);
  DriftTf(const DriftTf&) = delete;  // its thread calls back into this object
  DriftTf& operator=(const DriftTf&) = delete;

  /// From now on odometry lies here; before the first call, at identity.
  void set(const Pose& T_map_odom);

 private:
  void send();

  const std::string map_frame_;
  const std::string odom_frame_;
  std::mutex mutex_;  // of the next line, all that both threads use
  Pose T_map_odom_ = Pose::Identity();
  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  ros::Publisher tf_;
  ros::Time sent_;
  ros::WallTimer timer_;
  ros::AsyncSpinner spinner_{1, &queue_};  // last, so that it ends first
};

}  // namespace portolan
