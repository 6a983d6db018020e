// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace portolan {

/// A latched topic whose message takes time in proportion to the whole map: it is made when the map
/// has changed and someone listens, at most once in an interval, and in no more than a tenth of
/// the time, however large the map grows.
template <class Message>
class WholeMapTopic {
 public:
  /// Tells one state of a map from another; all zeros: nothing was ever in it.
  struct Version {
    std::size_t generation = 0;
    std::uint64_t revision = 0;

    friend bool operator==(const Version& a, const Version& b) {
      return a.generation == b.generation && a.revision == b.revision;
    }
  };

  /// `make` may throw std::runtime_error where the map can't be a message. `interval` [s].
  WholeMapTopic(ros::NodeHandle& handle, const std::string& topic, double interval,
                std::function<Message()> make)
      : publisher_(handle.advertise<Message>(topic, 1, true)),
        interval_(interval),
        make_(std::move(make)) {}

  /// Sends the map if it is due.
  void publish(const Version& now) {
    const ros::WallTime start = ros::WallTime::now();
    if (now == published_ || publisher_.getNumSubscribers() == 0 || start < due_) return;
    published_ = now;
    try {
      publisher_.publish(make_());
    } catch (const std::runtime_error& error) {
      ROS_ERROR_THROTTLE(60.0, "%s", error.what());
    }
    constexpr double kRest = 9.0;  // times as long as the work
    const ros::WallTime end = ros::WallTime::now();
    due_ = std::max(start + interval_, end + (end - start) * kRest);
  }

 private:
  ros::Publisher publisher_;
  ros::WallDuration interval_;
  std::function<Message()> make_;
  Version published_;
  ros::WallTime due_;
};

}  // namespace portolan
