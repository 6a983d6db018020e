// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/posed_input.hpp"

namespace portolan {

inline Time at(double s) { return Time(seconds(s)); }

/// `child` seen from `parent` at the stamp `s` [s].
inline geometry_msgs::TransformStamped transform(const std::string& parent,
                                                 const std::string& child, double s,
                                                 const Pose& T_parent_child = Pose::Identity()) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.header.stamp = ros_convert::time(at(s));
  message.child_frame_id = child;
  message.transform = ros_convert::transform(T_parent_child);
  return message;
}

inline tf2_msgs::TFMessage tf_message(const geometry_msgs::TransformStamped& transform) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

/// A robot that drives along x with 1 m/s: odom -> base_link moves, base_link -> laser does not.
class PosedInputTest : public testing::Test {
 protected:
  PosedInputTest() { add_static_laser(); }

  /// What was used: which message, and the pose that it was given.
  struct Used {
    std::string name;
    PosedInput::SensorPose pose;
  };

  static Pose T_odom_base(double s) { return planar_pose(s, 0.0, 0.0); }
  static Pose T_base_laser() { return planar_pose(0.0, 0.5, 0.0); }

  void add_static_laser() {
    input.receive_tf(tf_message(transform("base_link", "laser", 0.0, T_base_laser())), true, now);
  }

  /// The robot's pose at the stamp.
  void odometry(double s, const std::string& slash = "") {
    input.receive_tf(tf_message(transform(slash + "odom", slash + "base_link", s, T_odom_base(s))),
                     false, now);
    input.poll(now);
  }

  PosedInput::Message message(const std::string& name, double first, double last,
                              const std::string& frame = "laser") {
    return {frame, at(first), at(last), [this, name](const PosedInput::SensorPose& pose) {
              used.push_back({name, pose});
              return outcome;
            }};
  }
  void scan(const std::string& name, double s, const std::string& frame = "laser") {
    input.receive(scans, message(name, s, s, frame), now);
  }

  std::string names() const {
    std::string all;
    for (const Used& u : used) all += (all.empty() ? "" : " ") + u.name;
    return all;
  }
  const Tally& tally(std::size_t i = 0) const { return input.tallies()[i]; }
  std::uint64_t dropped(Drop reason) const { return tally().dropped(reason); }

  /// Nothing is ever lost without a count.
  void TearDown() override {
    std::uint64_t waiting = 0;
    for (const Tally& t : input.tallies()) waiting += t.waiting();
    EXPECT_LE(waiting, static_cast<std::uint64_t>(options().queue_size));
    now += seconds(1000.0);
    input.poll(now);  // one that came before the clock begins to wait now
    now += seconds(1000.0);
    input.poll(now);
    for (const Tally& t : input.tallies()) {
      EXPECT_EQ(t.waiting(), 0u);
      EXPECT_EQ(t.received(), t.used() + t.lost() + t.dropped(Drop::thinned));
    }
  }

  static PosedInputOptions options() {
    PosedInputOptions options;
    options.queue_size = 20;
    options.order_wait = 0.0;
    return options;
  }

  Time now = at(100.0);
  PosedInput input{options()};
  std::size_t scans = input.add_input("scans");
  std::optional<Outcome> outcome = Outcome::inserted;
  std::vector<Used> used;
};

}  // namespace portolan
