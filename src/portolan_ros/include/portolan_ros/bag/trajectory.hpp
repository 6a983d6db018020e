// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>
#include <vector>

#include "portolan/correction.hpp"
#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// The robot's way through odometry, to be written out corrected.
class Trajectory {
 public:
  Trajectory(const std::string& odom_frame, const std::string& base_frame);

  /// Keeps what a message says of base_frame in odom_frame; the first word on a stamp counts.
  void receive_tf(const tf2_msgs::TFMessage& message);
  void receive_odometry(const nav_msgs::Odometry& message);

  bool empty() const { return T_odom_base_.empty(); }

  /// Where the robot was in the map at each stamp, in their order.
  std::vector<Pose> in_map(const Correction& correction) const;

  /// The same as TUM text: `stamp tx ty tz qx qy qz qw`, a line each.
  std::string tum(const Correction& correction) const;

 private:
  void keep(const std_msgs::Header& header, const std::string& child, const Pose& T_odom_base);

  std::string odom_frame_;
  std::string base_frame_;
  std::map<Time, Pose> T_odom_base_;
};

}  // namespace portolan
