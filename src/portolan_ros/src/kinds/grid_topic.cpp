// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/grid_topic.hpp"

#include <ros/console.h>

#include <stdexcept>
#include <utility>

namespace portolan {

GridTopic::GridTopic(ros::NodeHandle& handle, const std::string& topic,
                     ros_convert::GridSheet sheet, const Remapper<GridMapper>& source,
                     std::string map_frame, double max_cells)
    : source_(source), sheet_(sheet), map_frame_(std::move(map_frame)), max_cells_(max_cells) {
  const ros::SubscriberStatusCallback came = [this](const ros::SingleSubscriberPublisher&) {
    someone_came_ = true;
  };
  const ros::SubscriberStatusCallback left;
  whole_ = handle.advertise<nav_msgs::OccupancyGrid>(topic, 1, came, left, {}, true);
  metadata_ = handle.advertise<nav_msgs::MapMetaData>(topic + "_metadata", 1, came, left, {}, true);
  // Whoever comes to the updates later than to the map may have missed some: it gets the whole map.
  updates_ = handle.advertise<map_msgs::OccupancyGridUpdate>(topic + "_updates", 10, came, left);
}

void GridTopic::publish(const ros::Time& stamp) {
  const bool someone_listens = whole_.getNumSubscribers() > 0 || updates_.getNumSubscribers() > 0 ||
                               metadata_.getNumSubscribers() > 0;
  if (!someone_listens) return;
  const bool is_another_map =
      generation_ != source_.generation() || !(rect_ == current_rect()) || someone_came_;
  try {
    if (is_another_map) {
      publish_whole(stamp);
    } else {
      publish_changes(stamp);
    }
  } catch (const std::runtime_error& error) {
    ROS_ERROR_THROTTLE(60.0, "%s", error.what());
  }
}

nav_msgs::OccupancyGrid GridTopic::whole(const ros::Time& stamp) const {
  const CellRect rect = current_rect();
  const double cells = static_cast<double>(rect.width()) * rect.height();
  if (cells > max_cells_) {
    throw std::runtime_error("the map is too large to publish: " + std::to_string(rect.width()) +
                             " x " + std::to_string(rect.height()) + " cells; see ~max_cells");
  }
  nav_msgs::OccupancyGrid message = ros_convert::occupancy_grid(source_.map(), sheet_, rect);
  message.header.stamp = stamp;
  message.header.frame_id = map_frame_;
  message.info.map_load_time = stamp;
  return message;
}

CellRect GridTopic::current_rect() const {
  const CellRect seen = ros_convert::published_rect(source_.map(), sheet_);
  // An empty map is shown as the last one with nothing known: no one can show zero cells.
  return seen.empty() ? rect_ : seen;
}

void GridTopic::publish_whole(const ros::Time& stamp) {
  const nav_msgs::OccupancyGrid message = whole(stamp);
  rect_ = current_rect();
  generation_ = source_.generation();
  revision_ = source_.map().revision();
  someone_came_ = false;
  if (rect_.empty()) return;
  whole_.publish(message);
  metadata_.publish(message.info);
}

void GridTopic::publish_changes(const ros::Time& stamp) {
  const GridMapper& map = source_.map();
  const CellRect changed = intersected(
      sheet_ ? map.changed_since(revision_, *sheet_) : map.changed_since(revision_), rect_);
  revision_ = map.revision();
  if (changed.empty()) return;
  map_msgs::OccupancyGridUpdate message =
      ros_convert::occupancy_grid_update(map, sheet_, rect_, changed);
  message.header.stamp = stamp;
  message.header.frame_id = map_frame_;
  updates_.publish(message);
}

}  // namespace portolan
