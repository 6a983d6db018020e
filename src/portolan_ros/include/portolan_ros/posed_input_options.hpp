// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "portolan/options.hpp"

namespace portolan {

/// How sensor messages are given their pose.
struct PosedInputOptions {
  std::string odom_frame = "odom";
  double tf_wait = 1.0;
  double order_wait = 0.2;
  double tf_buffer = 30.0;
  int queue_size = 200;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("odom_frame", self.odom_frame,
          "frame in which sensors are posed; set it to the map frame where the robot has a "
          "localiser of its own");
    visit("tf_wait", self.tf_wait, "how long a message waits for its transform [s]",
          within(0.0, 60.0));
    visit("order_wait", self.order_wait,
          "how long a message waits for those of other topics before it [s]", within(0.0, 1.0));
    visit("tf_buffer", self.tf_buffer, "how much of tf is remembered [s]", within(1.0, 3600.0));
    visit("queue_size", self.queue_size, "messages that may wait for their transform or their turn",
          within(1, 100000));
    visit.require(!self.odom_frame.empty(), "odom_frame must not be empty");
  }
};

}  // namespace portolan
