// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/GetMap.h>
#include <ros/service_server.h>

#include <array>
#include <string>

#include "portolan/grid/map_files.hpp"
#include "portolan/options.hpp"
#include "portolan_ros/kinds/grid_topic.hpp"

namespace portolan {

/// How a grid map leaves the node.
struct GridOutputOptions {
  double max_cells = 1e8;
  PixelMode file_mode = PixelMode::trinary;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_cells", self.max_cells, "larger maps are neither published nor saved [cell]",
          within(1.0, 1e9));
    visit("file_mode", self.file_mode,
          "saved pictures tell free, occupied and unknown, or keep probabilities");
  }
};

/// The topics and services of the occupancy grid: `map`, a topic for each layer, `dynamic_map`
/// and `static_map`.
class GridOutputs {
 public:
  GridOutputs(ros::NodeHandle& handle, const GridOutputOptions& options,
              const std::string& map_frame, const Remapper<GridMapper>& source);

  /// Sends what changed since the last time.
  void publish(const ros::Time& stamp);

 private:
  bool answer(nav_msgs::GetMap::Response& response) const;

  GridTopic fused_;
  std::array<GridTopic, kGridLayers.size()> layers_;
  std::array<ros::ServiceServer, 2> services_;
};

}  // namespace portolan
