// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <vector>

#include "portolan/sim/simulation.hpp"
#include "publishers.hpp"
#include "robot_sim_options.hpp"
#include "truth_recorder.hpp"

namespace portolan::sim {

/// The simulated robot as a node: it drives, measures, and makes the clock.
class RobotSimNode {
 public:
  /// Throws OptionsError with every fault of the parameters at once.
  RobotSimNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

  /// Runs until ROS shuts down.
  void run();

 private:
  void begin();
  bool held();
  void tick();
  void finish();
  void keep_pace();

  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool write_truth(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  RobotSimOptions options_;
  SimulationOptions simulation_options_;
  std::optional<Simulation> simulation_;
  std::optional<TruthRecorder> truth_;
  std::optional<Publishers> publishers_;
  bool waiting_ = true;
  std::optional<Time> finished_at_;
  std::optional<ros::WallTime> began_;  // in real time, for the pace
  Time began_at_;                       // in simulated time
  ros::Subscriber commands_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace portolan::sim
