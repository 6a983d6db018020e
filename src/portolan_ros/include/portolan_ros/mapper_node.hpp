// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <chrono>
#include <stdexcept>
#include <string>

#include "portolan_ros/convert/correction.hpp"
#include "portolan_ros/map_keeper.hpp"
#include "portolan_ros/map_services.hpp"
#include "portolan_ros/mapper_node_options.hpp"
#include "portolan_ros/params.hpp"
#include "portolan_ros/pipeline.hpp"
#include "portolan_ros/pipeline_diagnosis.hpp"
#include "portolan_ros/still_clock.hpp"
#include "portolan_ros/subscriptions.hpp"

namespace portolan {

/// A node that draws one kind of map. It spins one thread and owns its parts; none knows another.
template <class Kind>
class MapperNode {
 public:
  using Mapper = typename Kind::Mapper;

  /// Throws OptionsError with every fault of the parameters at once.
  MapperNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
      : handle_(handle), private_handle_(private_handle) {
    subscribe_to_poses();
    Kind::inputs([this](const std::string& name, const std::string& noun, auto convert) {
      this->subscribe_to_input(name, noun, convert);
    });
    diagnostics_.setHardwareID("none");
    diagnostics_.add("mapping", [this](auto& status) { diagnosis_.fill(status); });
  }

 private:
  static MapperNodeOptions<Kind> read(const ros::NodeHandle& private_handle) {
    MapperNodeOptions<Kind> options;
    read_parameters(private_handle, options);
    return options;
  }

  static Time now() { return ros_convert::time(ros::Time::now()); }

  void subscribe_to_poses();

  template <class Message, class SensorReading>
  void subscribe_to_input(const std::string& name, const std::string& noun,
                          std::optional<Sensed<SensorReading>> (*convert)(const Message&));

  void correct(const portolan_msgs::DriftCorrection& message);
  std::string map_name() const {
    return string_parameter(private_handle_, "map_name", options_.node.map_name);
  }
  void redraw();

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  MapperNodeOptions<Kind> options_ = read(private_handle_);
  Pipeline<Kind> pipeline_{options_.pipeline, options_.mapper, options_.filter};
  typename Kind::Outputs outputs_{handle_, options_.output, options_.node.map_frame,
                                  pipeline_.remapper()};
  PipelineDiagnosis<Kind> diagnosis_{pipeline_};
  StillClock still_clock_;
  diagnostic_updater::Updater diagnostics_{handle_, private_handle_};
  Subscriptions subscriptions_{handle_};
  MapKeeper<Kind> keeper_{pipeline_.remapper(), options_, [this] { return map_name(); }};
  MapServices services_{private_handle_,
                        {[this] { return keeper_.save(); }, [this] { return keeper_.load(); },
                         [this] { return keeper_.reset(); }}};
  ServicesOf<Kind> more_services_{private_handle_, pipeline_.remapper()};

  static constexpr double kRedrawPeriod = 0.05;  // [s]
  // Wall timers: simulated time may stand still, or run back.
  ros::WallTimer redraw_timer_ = handle_.createWallTimer(
      ros::WallDuration(kRedrawPeriod), [this](const ros::WallTimerEvent&) { redraw(); });
  ros::WallTimer publish_timer_ = handle_.createWallTimer(
      ros::WallDuration(options_.node.publish_interval),
      [this](const ros::WallTimerEvent&) { outputs_.publish(ros::Time::now()); });
  ros::WallTimer diagnostics_timer_ =
      handle_.createWallTimer(ros::WallDuration(options_.node.diagnostic_period),
                              [this](const ros::WallTimerEvent&) { diagnostics_.force_update(); });
};

template <class Kind>
void MapperNode<Kind>::subscribe_to_poses() {
  subscriptions_.add_poses(options_.node.odom_topic, pipeline_, &now);
  subscriptions_.add<portolan_msgs::DriftCorrection>(
      "drift_correction", 1,
      [this](const portolan_msgs::DriftCorrection& message) { correct(message); });
}

template <class Kind>
template <class Message, class SensorReading>
void MapperNode<Kind>::subscribe_to_input(
    const std::string& name, const std::string& noun,
    std::optional<Sensed<SensorReading>> (*convert)(const Message&)) {
  const std::size_t input = pipeline_.add_input(noun);
  for (const std::string& topic : options_.topics.by_input.at(name)) {
    subscriptions_.add<Message>(topic, options_.pipeline.posing.queue_size,
                                [this, input, convert](const Message& message) {
                                  pipeline_.receive(input, convert(message), now());
                                });
  }
}

template <class Kind>
void MapperNode<Kind>::correct(const portolan_msgs::DriftCorrection& message) {
  try {
    pipeline_.correct(ros_convert::correction(message, options_.node.map_frame,
                                              options_.pipeline.posing.odom_frame),
                      ros_convert::time(message.header.stamp), now());
  } catch (const std::invalid_argument& error) {
    diagnosis_.refuse_correction();
    ROS_ERROR_THROTTLE(10.0, "drift_correction is refused: %s", error.what());
  }
}

template <class Kind>
void MapperNode<Kind>::redraw() {
  pipeline_.poll(now());
  if (still_clock_.stands(now(), std::chrono::steady_clock::now())) pipeline_.settle(now());
  const ros::WallTime end =
      ros::WallTime::now() + ros::WallDuration(kRedrawPeriod * options_.redraw_share);
  pipeline_.remapper().replay([end] { return ros::WallTime::now() < end; });
}

}  // namespace portolan
