// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <string>

#include "portolan/remapper.hpp"
#include "portolan_ros/convert/occupancy_grid.hpp"

namespace portolan {

/// Publishes one sheet of a grid map: the whole of it, latched, when it must be, and afterwards
/// only the rectangle that changed, on `<topic>_updates`. Makes messages only while someone
/// listens.
class GridTopic {
 public:
  GridTopic(ros::NodeHandle& handle, const std::string& topic, ros_convert::GridSheet sheet,
            const Remapper<GridMapper>& source, std::string map_frame, double max_cells);
  GridTopic(const GridTopic&) = delete;  // the publishers call back into this object
  GridTopic& operator=(const GridTopic&) = delete;

  /// Sends what changed since the last time.
  void publish(const ros::Time& stamp);

  /// The whole sheet as it is now. Throws std::runtime_error where it has over `max_cells` cells.
  nav_msgs::OccupancyGrid whole(const ros::Time& stamp) const;

 private:
  CellRect current_rect() const;
  void publish_whole(const ros::Time& stamp);
  void publish_changes(const ros::Time& stamp);

  const Remapper<GridMapper>& source_;
  ros_convert::GridSheet sheet_;
  std::string map_frame_;
  double max_cells_;
  ros::Publisher whole_;
  ros::Publisher metadata_;
  ros::Publisher updates_;
  CellRect rect_;  // as last published
  std::uint64_t revision_ = 0;
  std::size_t generation_ = 0;
  bool someone_came_ = false;
};

}  // namespace portolan
