// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <octomap_msgs/GetOctomap.h>
#include <octomap_msgs/Octomap.h>
#include <ros/service_server.h>
#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <string>

#include "portolan/octo/octree_mirror.hpp"
#include "portolan/octo/projection.hpp"
#include "portolan/remapper.hpp"
#include "portolan_ros/kinds/cell_markers.hpp"
#include "portolan_ros/kinds/octo_output_options.hpp"
#include "portolan_ros/kinds/whole_map_topic.hpp"

namespace portolan {

/// The topics and services of the 3D map; names of octomap_server.
class OctoOutputs {
 public:
  OctoOutputs(ros::NodeHandle& handle, const OctoOutputOptions& options,
              const std::string& map_frame, const Remapper<OctoMapper>& source);
  OctoOutputs(const OctoOutputs&) = delete;  // topics and services call back into this object
  OctoOutputs& operator=(const OctoOutputs&) = delete;

  /// Sends what changed since the last time, where someone listens.
  void publish(const ros::Time& stamp);

 private:
  using GetOctomap = octomap_msgs::GetOctomap;
  using Octomap = octomap_msgs::Octomap;

  Octomap binary();
  Octomap full();
  sensor_msgs::PointCloud2 centers() const;
  nav_msgs::OccupancyGrid projected();
  void publish_markers(const ros::Time& stamp);
  ros::Publisher advertise_markers(ros::NodeHandle& handle);
  ros::ServiceServer advertise_tree(ros::NodeHandle& handle, const std::string& name,
                                    Octomap (OctoOutputs::*make)());
  const octomap::OcTree& tree();
  template <class Message>
  Message stamped(Message message) const;

  OctoOutputOptions options_;
  std::string map_frame_;
  const Remapper<OctoMapper>& source_;
  OctreeMirror mirror_;
  Projection projection_;
  nav_msgs::MapMetaData projected_info_;  // as last published
  CellMarkers markers_;
  ros::Publisher markers_publisher_;
  WholeMapTopic<Octomap> binary_;
  WholeMapTopic<Octomap> full_;
  WholeMapTopic<sensor_msgs::PointCloud2> centers_;
  WholeMapTopic<nav_msgs::OccupancyGrid> projected_;
  std::array<ros::ServiceServer, 2> services_;
};

}  // namespace portolan
