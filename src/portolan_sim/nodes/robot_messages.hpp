// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "event_messages.hpp"
#include "portolan/sim/any_sensor.hpp"
#include "robot_sim_options.hpp"

namespace portolan::sim {

/// What the simulated robot says, as messages by topic, for whoever publishes or records them.
class RobotMessages {
 public:
  RobotMessages(const RobotSimOptions& options, const std::vector<AnySensor>& sensors);

  /// Calls `say(topic, message)` for each message that the event makes: odometry comes on /tf as
  /// well, features with their camera.
  template <class Say>
  void for_each(const Event& event, Say&& say) const {
    const std_msgs::Header header = header_of(event);
    std::visit([&](const auto& z) { this->for_each(header, event, z, say); }, event.payload);
  }

  /// The mounts of all sensors, for /tf_static.
  tf2_msgs::TFMessage mounts_at(Time now, const std::vector<AnySensor>& sensors) const;

  /// The topic of the camera's calibration: camera_info beside its features.
  static std::string info_topic(const std::string& features);

 private:
  std_msgs::Header header_of(const Event& event) const;
  nav_msgs::Odometry odometry(std_msgs::Header header, const Event::Odometry& z) const;
  nav_msgs::Odometry truth(std_msgs::Header header, const Event::Truth& z) const;
  static tf2_msgs::TFMessage transform(const nav_msgs::Odometry& odometry, const Pose& T_odom_base);

  template <class Payload, class Say>
  void for_each(const std_msgs::Header& header, const Event& event, const Payload& z,
                Say&& say) const {
    if constexpr (std::is_same_v<Payload, Event::Odometry>) {
      const nav_msgs::Odometry where = odometry(header, z);
      say(event.topic, where);
      say("/tf", transform(where, z.T_odom_base));
    } else if constexpr (std::is_same_v<Payload, Event::Truth>) {
      say(event.topic, truth(header, z));
    } else {
      if constexpr (std::is_same_v<Payload, ImageFeatures>) {
        say(info_topic(event.topic), camera_info(header, cameras_.at(event.frame)));
      }
      say(event.topic, message(header, z));
    }
  }

  RobotSimOptions options_;
  std::map<std::string, Camera::Options> cameras_;  // by frame
};

}  // namespace portolan::sim
