// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap_msgs/BoundingBoxQuery.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "portolan/octo/octo_mapper.hpp"
#include "portolan/remapper.hpp"

namespace portolan {

/// `~clear_bbx`: somebody's word that a box of the map is free. It is kept in the log as an
/// observation of this moment, so it outlives corrections and moves with them.
class OctoServices {
 public:
  OctoServices(ros::NodeHandle& private_handle, Remapper<OctoMapper>& map);
  OctoServices(const OctoServices&) = delete;  // the service calls back into this object
  OctoServices& operator=(const OctoServices&) = delete;

 private:
  using Query = octomap_msgs::BoundingBoxQuery;

  bool clear(const Query::Request& request);

  Remapper<OctoMapper>& map_;
  SensorId next_word_;
  ros::ServiceServer server_;
};

}  // namespace portolan
