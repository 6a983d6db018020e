// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/grid_outputs.hpp"

#include <ros/console.h>

#include <stdexcept>

namespace portolan {

namespace {

std::string layer_topic(GridLayer layer) {
  return std::string("map/") + enum_names(layer).at(static_cast<std::size_t>(layer));
}

}  // namespace

GridOutputs::GridOutputs(ros::NodeHandle& handle, const GridOutputOptions& options,
                         const std::string& map_frame, const Remapper<GridMapper>& source)
    : fused_(handle, "map", std::nullopt, source, map_frame, options.max_cells),
      layers_{{{handle, layer_topic(GridLayer::laser), GridLayer::laser, source, map_frame,
                options.max_cells},
               {handle, layer_topic(GridLayer::sonar), GridLayer::sonar, source, map_frame,
                options.max_cells},
               {handle, layer_topic(GridLayer::cloud), GridLayer::cloud, source, map_frame,
                options.max_cells}}} {
  using Get = nav_msgs::GetMap;
  const boost::function<bool(Get::Request&, Get::Response&)> answer_call =
      [this](Get::Request&, Get::Response& response) { return answer(response); };
  services_ = {handle.advertiseService("dynamic_map", answer_call),
               handle.advertiseService("static_map", answer_call)};
}

void GridOutputs::publish(const ros::Time& stamp) {
  fused_.publish(stamp);
  for (GridTopic& layer : layers_) layer.publish(stamp);
}

bool GridOutputs::answer(nav_msgs::GetMap::Response& response) const {
  try {
    response.map = fused_.whole(ros::Time::now());
    return true;
  } catch (const std::runtime_error& error) {
    ROS_ERROR("%s", error.what());
    return false;
  }
}

}  // namespace portolan
