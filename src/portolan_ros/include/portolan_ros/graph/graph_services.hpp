// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/AddArc.h>
#include <portolan_msgs/ListArcs.h>
#include <portolan_msgs/SetArcs.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <vector>

#include "portolan_ros/graph/graph_pipeline.hpp"

namespace portolan {

/// Lets users look at arcs, take them out and in, and add their own.
class GraphServices {
 public:
  GraphServices(ros::NodeHandle& private_handle, GraphPipeline& pipeline);
  GraphServices(const GraphServices&) = delete;  // the services call back into this object
  GraphServices& operator=(const GraphServices&) = delete;

 private:
  bool list(portolan_msgs::ListArcs::Request& request, portolan_msgs::ListArcs::Response& response);
  bool enable(portolan_msgs::SetArcs::Request& request, portolan_msgs::SetArcs::Response& response);
  bool disable(portolan_msgs::SetArcs::Request& request,
               portolan_msgs::SetArcs::Response& response);
  bool add(portolan_msgs::AddArc::Request& request, portolan_msgs::AddArc::Response& response);

  GraphPipeline& pipeline_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace portolan
