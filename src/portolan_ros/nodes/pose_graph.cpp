// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/pose_graph_node.hpp"
#include "portolan_ros/report.hpp"

int main(int argc, char** argv) try {
  ros::init(argc, argv, "pose_graph");
  const portolan::PoseGraphNode node(ros::NodeHandle(), ros::NodeHandle("~"));
  ros::spin();
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
