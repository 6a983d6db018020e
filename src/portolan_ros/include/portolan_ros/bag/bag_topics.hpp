// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <rosbag/message_instance.h>
#include <tf2_msgs/TFMessage.h>

#include <chrono>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "portolan/time.hpp"
#include "portolan_ros/bag/trajectory.hpp"
#include "portolan_ros/convert/basics.hpp"

namespace portolan {

/// What becomes of a bag's messages, by topic: what subscriptions are to a live node.
class BagTopics {
 public:
  /// Calls back with each message of this type on the topic, and with its time in the bag.
  template <class Message, class Callback>
  void add(const std::string& topic, Callback callback) {
    handlers_[ros_convert::without_slash(topic)].push_back(
        [callback](const rosbag::MessageInstance& instance, Time now) {
          if (const auto message = instance.instantiate<Message>()) callback(*message, now);
        });
  }

  /// Lets a trajectory and a pipeline know of tf and, unless its topic is empty, of odometry.
  template <class Pipeline>
  void add_poses(const std::string& odom_topic, Trajectory& trajectory, Pipeline& pipeline) {
    const auto on_tf = [&trajectory, &pipeline](bool is_static) {
      return [&trajectory, &pipeline, is_static](const tf2_msgs::TFMessage& message, Time now) {
        trajectory.receive_tf(message);
        pipeline.receive_tf(message, is_static, now);
      };
    };
    add<tf2_msgs::TFMessage>("tf", on_tf(false));
    add<tf2_msgs::TFMessage>("tf_static", on_tf(true));
    if (odom_topic.empty()) return;
    add<nav_msgs::Odometry>(odom_topic,
                            [&trajectory, &pipeline](const nav_msgs::Odometry& message, Time now) {
                              trajectory.receive_odometry(message);
                              pipeline.receive_odometry(message, now);
                            });
  }

  /// The topics' names without their slashes.
  std::set<std::string> names() const;

  /// Hands on one message of the bag; one on no topic of ours is left out.
  void take(const rosbag::MessageInstance& message);

  /// The time in the bag of the last message that was handed on.
  Time newest() const { return newest_; }
  /// What the messages have taken so far [s].
  double wall_time() const { return wall_time_.count(); }

 private:
  using Handler = std::function<void(const rosbag::MessageInstance&, Time)>;

  std::map<std::string, std::vector<Handler>> handlers_;  // by topic without its slash
  Time newest_;
  std::chrono::duration<double> wall_time_{0.0};  // [s]
};

}  // namespace portolan
