// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <map>
#include <string>
#include <vector>

#include "portolan/sim/any_sensor.hpp"
#include "portolan/sim/truth_grid.hpp"
#include "robot_messages.hpp"
#include "robot_sim_options.hpp"

namespace portolan::sim {

/// Everything that the simulated robot says, by topic.
class Publishers {
 public:
  Publishers(const ros::NodeHandle& handle, const RobotSimOptions& options,
             const std::vector<AnySensor>& sensors);

  /// Publishes all messages that the event makes.
  void publish(const Event& event);
  void publish_clock(Time now);
  void publish_path_finished(bool finished);
  /// The mounts of all sensors, latched.
  void publish_mounts(Time now, const std::vector<AnySensor>& sensors);

  /// The true map, latched: what a perfect mapper would draw.
  void publish_truth(Time now, const TruthGrid& grid);

  /// The first of these topics that has fewer listeners than times that it is named; empty where
  /// all are heard. Throws OptionsError for a topic that is none of ours.
  std::string unheard(const std::vector<std::string>& topics) const;

 private:
  template <class Message>
  void advertise(const std::string& topic, bool latch = false);

  ros::NodeHandle handle_;
  RobotSimOptions options_;
  RobotMessages messages_;
  std::map<std::string, ros::Publisher> by_topic_;
};

}  // namespace portolan::sim
