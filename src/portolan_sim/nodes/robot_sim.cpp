// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>

#include "portolan_ros/report.hpp"
#include "robot_sim_node.hpp"

int main(int argc, char** argv) try {
  ros::init(argc, argv, "robot_sim");
  portolan::sim::RobotSimNode(ros::NodeHandle(), ros::NodeHandle("~")).run();
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
