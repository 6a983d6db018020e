// SPDX-License-Identifier: BSD-3-Clause
#include "publishers.hpp"

#include <nav_msgs/OccupancyGrid.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>

#include <utility>

#include "portolan_ros/convert/basics.hpp"

namespace portolan::sim {

namespace {

template <class Sensor>
using MessageOf =
    decltype(message(std_msgs::Header{},
                     std::declval<Sensor&>().sense(std::declval<World>(), std::declval<Pose>())));

std::int8_t percent(TruthGrid::Cell cell) {
  if (cell == TruthGrid::Cell::unknown) return -1;
  return cell == TruthGrid::Cell::occupied ? 100 : 0;
}

}  // namespace

Publishers::Publishers(const ros::NodeHandle& handle, const RobotSimOptions& options,
                       const std::vector<AnySensor>& sensors)
    : handle_(handle), options_(options), messages_(options, sensors) {
  if (options.publish_clock) advertise<rosgraph_msgs::Clock>("/clock");
  advertise<tf2_msgs::TFMessage>("/tf");
  advertise<tf2_msgs::TFMessage>("/tf_static", true);
  advertise<nav_msgs::Odometry>("odom");
  advertise<nav_msgs::Odometry>("ground_truth");
  advertise<std_msgs::Bool>("path_finished", true);
  advertise<nav_msgs::OccupancyGrid>("ground_truth_map", true);
  const auto advertise_sensor = [this](const auto& sensor) {
    using Sensor = std::decay_t<decltype(sensor)>;
    const std::string& topic = sensor.options().topic;
    if constexpr (std::is_same_v<Sensor, Laser>) {
      advertise<sensor_msgs::LaserScan>(topic);
    } else if constexpr (std::is_same_v<Sensor, SonarRing>) {
      advertise<sensor_msgs::Range>(topic);
    } else {
      advertise<MessageOf<Sensor>>(topic);
    }
    if constexpr (std::is_same_v<Sensor, Camera>) {
      advertise<sensor_msgs::CameraInfo>(RobotMessages::info_topic(topic), true);
    }
  };
  for (const AnySensor& sensor : sensors) std::visit(advertise_sensor, sensor);
}

template <class Message>
void Publishers::advertise(const std::string& topic, bool latch) {
  // An unlimited queue: where time runs as fast as it can, nothing may be lost on our side.
  constexpr std::uint32_t kUnlimited = 0;
  if (by_topic_.count(topic) == 0) {
    by_topic_[topic] = handle_.advertise<Message>(topic, kUnlimited, latch);
  }
}

void Publishers::publish(const Event& event) {
  messages_.for_each(event, [this](const std::string& topic, const auto& message) {
    by_topic_.at(topic).publish(message);
  });
}

void Publishers::publish_clock(Time now) {
  if (!options_.publish_clock) return;
  rosgraph_msgs::Clock clock;
  clock.clock = ros_convert::time(now);
  by_topic_.at("/clock").publish(clock);
}

void Publishers::publish_truth(Time now, const TruthGrid& grid) {
  nav_msgs::OccupancyGrid message;
  message.header.stamp = ros_convert::time(now);
  message.header.frame_id = options_.map_frame;
  message.info.map_load_time = message.header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.origin.x();
  message.info.origin.position.y = grid.origin.y();
  message.info.origin.orientation.w = 1.0;
  for (const TruthGrid::Cell cell : grid.cells) message.data.push_back(percent(cell));
  by_topic_.at("ground_truth_map").publish(message);
}

void Publishers::publish_path_finished(bool finished) {
  std_msgs::Bool message;
  message.data = finished;
  by_topic_.at("path_finished").publish(message);
}

void Publishers::publish_mounts(Time now, const std::vector<AnySensor>& sensors) {
  by_topic_.at("/tf_static").publish(messages_.mounts_at(now, sensors));
}

std::string Publishers::unheard(const std::vector<std::string>& topics) const {
  std::map<std::string, std::uint32_t> wanted;
  for (const std::string& topic : topics) {
    const auto publisher = by_topic_.find(topic);
    if (publisher == by_topic_.end()) {
      throw OptionsError({"wait_for_subscribers = " + topic + " is no topic of this robot"});
    }
    if (publisher->second.getNumSubscribers() < ++wanted[topic]) return topic;
  }
  return {};
}

}  // namespace portolan::sim
