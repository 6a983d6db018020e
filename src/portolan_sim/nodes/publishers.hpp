// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <std_msgs/Header.h>

#include <map>
#include <string>
#include <vector>

#include "portolan/sim/any_sensor.hpp"
#include "portolan/sim/truth_grid.hpp"
#include "robot_sim_options.hpp"

namespace portolan::sim {

/// Everything that the simulated robot says, by topic.
class Publishers {
 public:
  Publishers(const ros::NodeHandle& handle, const RobotSimOptions& options,
             const std::vector<AnySensor>& sensors);

  /// Publishes an event on its topic; odometry on /tf as well, features with their camera.
  void publish(const Event& event);
  void publish_clock(Time now);
  void publish_path_finished(bool finished);
  /// The mounts of all sensors, latched.
  void publish_mounts(Time now, const std::vector<AnySensor>& sensors);

  /// The true map, latched: what a perfect mapper would draw.
  void publish_truth(Time now, const TruthGrid& grid);

  /// The first of these topics that nobody listens to yet; empty where all have listeners. Throws
  /// OptionsError for a topic that is none of ours.
  std::string unheard(const std::vector<std::string>& topics) const;

 private:
  template <class Message>
  void advertise(const std::string& topic, bool latch = false);
  void publish(const std_msgs::Header& header, const Event& event, const Event::Odometry& z);
  void publish(const std_msgs::Header& header, const Event& event, const Event::Truth& z);
  void publish(const std_msgs::Header& header, const Event& event, const ImageFeatures& z);
  template <class Payload>
  void publish(const std_msgs::Header& header, const Event& event, const Payload& z);

  ros::NodeHandle handle_;
  RobotSimOptions options_;
  std::map<std::string, ros::Publisher> by_topic_;
  std::map<std::string, Camera::Options> cameras_;  // by frame
};

}  // namespace portolan::sim
