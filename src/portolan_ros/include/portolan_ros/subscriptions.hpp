// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/transport_hints.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/function.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace portolan {

/// The subscriptions of a node; they end with this object.
class Subscriptions {
 public:
  explicit Subscriptions(const ros::NodeHandle& handle) : handle_(handle) {}

  /// Calls back with each message by reference; `queue` messages may wait for the node.
  template <class Message, class Callback>
  void add(const std::string& topic, int queue, Callback callback) {
    const boost::function<void(const typename Message::ConstPtr&)> call =
        [callback](const typename Message::ConstPtr& message) { callback(*message); };
    subscribers_.push_back(handle_.subscribe<Message>(topic, static_cast<std::uint32_t>(queue),
                                                      call, ros::VoidConstPtr(),
                                                      ros::TransportHints().tcpNoDelay()));
  }

  /// Lets a pipeline know of tf and, unless its topic is empty, of odometry; `now` says the time.
  template <class Pipeline, class Clock>
  void add_poses(const std::string& odom_topic, Pipeline& pipeline, Clock now) {
    constexpr int kQueue = 1000;
    const auto on_tf = [&pipeline, now](bool is_static) {
      return [&pipeline, now, is_static](const tf2_msgs::TFMessage& message) {
        pipeline.receive_tf(message, is_static, now());
      };
    };
    add<tf2_msgs::TFMessage>("/tf", kQueue, on_tf(false));
    add<tf2_msgs::TFMessage>("/tf_static", kQueue, on_tf(true));
    if (odom_topic.empty()) return;
    add<nav_msgs::Odometry>(odom_topic, kQueue,
                            [&pipeline, now](const nav_msgs::Odometry& message) {
                              pipeline.receive_odometry(message, now());
                            });
  }

 private:
  ros::NodeHandle handle_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace portolan
