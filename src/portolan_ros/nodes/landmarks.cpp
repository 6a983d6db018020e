// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/landmark_kind.hpp"
#include "portolan_ros/mapper_node.hpp"
#include "portolan_ros/report.hpp"

int main(int argc, char** argv) try {
  ros::init(argc, argv, "landmarks");
  const portolan::MapperNode<portolan::LandmarkKind> node(ros::NodeHandle(), ros::NodeHandle("~"));
  ros::spin();
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
