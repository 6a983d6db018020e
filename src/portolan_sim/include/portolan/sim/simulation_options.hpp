// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "portolan/options.hpp"
#include "portolan/sim/beacon_receiver.hpp"
#include "portolan/sim/camera.hpp"
#include "portolan/sim/depth_camera.hpp"
#include "portolan/sim/landmark_sensor.hpp"
#include "portolan/sim/laser.hpp"
#include "portolan/sim/lidar.hpp"
#include "portolan/sim/odometry.hpp"
#include "portolan/sim/path_follower.hpp"
#include "portolan/sim/robot.hpp"
#include "portolan/sim/sonar_ring.hpp"
#include "portolan/sim/world_options.hpp"

namespace portolan::sim {

/// Who drives the robot.
enum class Drive {
  path,     ///< it follows its path by itself
  command,  ///< it obeys the velocities it is sent
};

constexpr std::array<const char*, 2> enum_names(Drive) { return {"path", "command"}; }

/// Where odometry begins to count.
enum class OdometryOrigin {
  map,    ///< at the robot's true pose: without drift its frame is the map's
  start,  ///< at zero, as wheels do
};

constexpr std::array<const char*, 2> enum_names(OdometryOrigin) { return {"map", "start"}; }

/// A whole experiment: world, robot, sensors, and the seed of all chance.
struct SimulationOptions {
  std::int64_t seed = 0;
  double start_time = 10.0;
  WorldOptions world;
  Drive drive = Drive::path;
  WorldOptions::Point start;
  std::vector<WorldOptions::Point> path;
  double command_timeout = 0.5;
  Robot::Options robot;
  PathFollower::Options follower;
  Odometry::Options odometry;
  OdometryOrigin odometry_origin = OdometryOrigin::map;
  double odometry_rate = 50.0;
  std::vector<Laser::Options> lasers = {Laser::Options{}};
  std::vector<SonarRing::Options> sonar_rings = {SonarRing::Options{}};
  std::vector<Lidar::Options> lidars;
  std::vector<DepthCamera::Options> depth_cameras;
  std::vector<LandmarkSensor::Options> landmark_sensors;
  std::vector<Camera::Options> cameras;
  std::vector<BeaconReceiver::Options> beacon_receivers;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("seed", self.seed, "the same seed gives the same run, to the last bit", at_least(0));
    visit("start_time", self.start_time, "stamp of the first moment [s]", above(0.0));
    visit("world", self.world, "what stands around the robot");
    visit("drive", self.drive, "who drives");
    visit("start", self.start,
          "[x, y, yaw]; empty: the path's begin, or the world's start [m, rad]");
    visit("path", self.path, "[x, y] points to drive along; empty: the world's tour [m]");
    visit("command_timeout", self.command_timeout,
          "stands still without a command for so long; "
          "0: goes on [s]",
          at_least(0.0));
    visit("robot", self.robot, "the body");
    visit("follower", self.follower, "how it follows a path");
    visit("odometry", self.odometry, "how its wheels err");
    visit("odometry_origin", self.odometry_origin, "where odometry begins to count");
    visit("odometry_rate", self.odometry_rate, "[Hz]", above_to(0.0, 1000.0));
    visit("lasers", self.lasers, "planar lasers");
    visit("sonar_rings", self.sonar_rings, "rings of sonars");
    visit("lidars", self.lidars, "lasers with several rings");
    visit("depth_cameras", self.depth_cameras, "cameras that measure depth");
    visit("landmark_sensors", self.landmark_sensors, "sensors that find landmarks");
    visit("cameras", self.cameras, "cameras in whose images landmarks are found");
    visit("beacon_receivers", self.beacon_receivers, "antennas that hear beacons");
    visit.require(self.start.empty() || self.start.size() == 3, "start must be [x, y, yaw]");
    visit.require(WorldOptions::have_size(self.path, 2), "path: each point must be [x, y]");
  }
};

}  // namespace portolan::sim
