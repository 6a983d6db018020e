// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "portolan/pose.hpp"
#include "portolan/sim/event.hpp"
#include "portolan/sim/pose_history.hpp"
#include "portolan/sim/simulation_options.hpp"
#include "portolan/sim/world.hpp"
#include "portolan/time.hpp"

namespace portolan::sim {

using AnySensor =
    std::variant<Laser, SonarRing, Lidar, DepthCamera, LandmarkSensor, Camera, BeaconReceiver>;

/// A frame on the robot.
struct Mount {
  std::string frame;
  Pose T_base_frame;
};

/// Where and when a sensor measures.
struct Moment {
  const World& world;
  const PoseHistory& T_map_base;
  const PoseHistory& T_odom_base;
  Time stamp;
  std::int64_t count;  ///< measurements before this one
};

/// Every sensor that the options name, in their order. Throws OptionsError where two share a frame.
std::vector<AnySensor> sensors_of(const SimulationOptions& options);

/// The frames of its data: one, or one for each sonar of a ring.
std::vector<Mount> mounts(const AnySensor& sensor);

/// Measurements per second; a ring that fires in turn counts each sonar's [Hz].
double rate(const AnySensor& sensor);

/// From a measurement's stamp until it is complete.
Duration duration(const AnySensor& sensor);

/// Measures, and adds what came of it.
void measure(AnySensor& sensor, const Moment& moment, std::vector<Event>& events);

}  // namespace portolan::sim
