// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "portolan/options.hpp"
#include "portolan/pose.hpp"

namespace portolan::sim {

/// What every sensor has: a name, a rate, and a place on the robot.
struct SensorOptions {
  std::string frame;             ///< unique; also names its stream of random numbers
  std::string topic;             ///< that a node publishes on
  double rate = 10.0;            ///< [Hz]
  std::vector<double> position;  ///< in the base frame [m]
  std::vector<double> rotation = {0.0, 0.0, 0.0};  ///< roll, pitch, yaw [rad]

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("frame", self.frame, "frame of its data; no two sensors share one");
    visit("topic", self.topic, "topic of its data");
    visit("rate", self.rate, "measurements per second [Hz]", above_to(0.0, 1000.0));
    visit("position", self.position, "[x, y, z] on the base [m]");
    visit("rotation", self.rotation, "[roll, pitch, yaw] on the base, x forward [rad]");
    visit.require(!self.frame.empty(), "frame must not be empty");
    visit.require(!self.topic.empty(), "topic must not be empty");
    visit.require(self.position.size() == 3, "position must be [x, y, z]");
    visit.require(self.rotation.size() == 3, "rotation must be [roll, pitch, yaw]");
  }
};

/// The sensor's place on the base, x forward, z up.
inline Pose mount(const SensorOptions& options) {
  const auto& p = options.position;
  const auto& r = options.rotation;
  return Eigen::Translation3d(p[0], p[1], p[2]) *
         Eigen::AngleAxisd(r[2], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(r[1], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(r[0], Eigen::Vector3d::UnitX());
}

}  // namespace portolan::sim
