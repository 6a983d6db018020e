// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/transport_hints.h>

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

 private:
  ros::NodeHandle handle_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace portolan
