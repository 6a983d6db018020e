// SPDX-License-Identifier: BSD-3-Clause
#include "robot_sim_node.hpp"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>

#include <chrono>

#include "portolan/sim/world_file.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/params.hpp"

namespace portolan::sim {

namespace {

/// So long do sensors go on after the path's end, that the last scans get their transforms.
constexpr Duration kAfterEnd = std::chrono::milliseconds(500);

bool is_empty(const WorldOptions& world) {
  return world.walls.empty() && world.boxes.empty() && world.cylinders.empty() &&
         world.landmarks.empty() && world.beacons.empty();
}

/// Calls back for whatever has come, or waits a little for something to come.
void serve(double patience) {
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(patience));
}

}  // namespace

RobotSimNode::RobotSimNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : handle_(handle), private_handle_(private_handle) {
  read_parameters(private_handle_, options_, simulation_options_);
  if (!options_.world_file.empty()) {
    simulation_options_.world = read_world(options_.world_file, options_.wall_height);
  }
  if (is_empty(simulation_options_.world)) {
    throw OptionsError({"world_file or world must say what stands around the robot"});
  }
  begin();
  const boost::function<void(const geometry_msgs::Twist&)> command =
      [this](const geometry_msgs::Twist& twist) {
        simulation_->command({twist.linear.x, twist.angular.z});
      };
  commands_ = handle_.subscribe<geometry_msgs::Twist>("cmd_vel", 1, command);
  services_ = {private_handle_.advertiseService("reset", &RobotSimNode::reset, this),
               private_handle_.advertiseService("truth", &RobotSimNode::write_truth, this)};
}

/// Puts everything at its start.
void RobotSimNode::begin() {
  simulation_.emplace(simulation_options_);
  truth_.emplace(options_, *simulation_);
  if (!publishers_) publishers_.emplace(handle_, options_, simulation_->sensors());
  publishers_->unheard(options_.wait_for_subscribers);
  publishers_->publish_mounts(simulation_->now(), simulation_->sensors());
  publishers_->publish_truth(simulation_->now(), truth_->grid());
  publishers_->publish_path_finished(false);
  publishers_->publish_clock(simulation_->now());
  if (truth_->wanted()) truth_->write(*simulation_);
  waiting_ = true;
  finished_at_.reset();
  began_.reset();
}

void RobotSimNode::run() {
  while (ros::ok()) {
    if (held()) {
      constexpr double kPatience = 0.02;  // [s]
      serve(kPatience);
    } else {
      serve(0.0);
      tick();
      keep_pace();
    }
  }
  if (truth_->wanted()) truth_->write(*simulation_);
}

/// True while time must not go on.
bool RobotSimNode::held() {
  const Time now = simulation_->now();
  if (waiting_) {
    publishers_->publish_clock(now);
    const std::string missing = publishers_->unheard(options_.wait_for_subscribers);
    waiting_ = !missing.empty();
    if (waiting_) ROS_INFO_THROTTLE(5.0, "waiting for someone to listen to %s", missing.c_str());
    return waiting_;
  }
  if (options_.stop_at_end && finished_at_ && now >= *finished_at_ + kAfterEnd) return true;
  return !options_.publish_clock && ros_convert::time(ros::Time::now()) <= now;
}

void RobotSimNode::tick() {
  const std::vector<Event> events = simulation_->step(Simulation::kTick);
  publishers_->publish_clock(simulation_->now());
  for (const Event& event : events) {
    publishers_->publish(event);
    truth_->record(*simulation_, event);
  }
  if (simulation_->path_finished()) finish();
}

/// Once, when the path has come to its end and the sensors have had their last look.
void RobotSimNode::finish() {
  if (!finished_at_) finished_at_ = simulation_->now();
  if (simulation_->now() != *finished_at_ + kAfterEnd) return;
  if (truth_->wanted()) truth_->write(*simulation_);
  publishers_->publish_path_finished(true);
}

/// Waits until real time has come as far as simulated time has.
void RobotSimNode::keep_pace() {
  if (options_.real_time_factor == 0.0 || !options_.publish_clock) return;
  if (!began_) {
    began_ = ros::WallTime::now();
    began_at_ = simulation_->now();
  }
  const double elapsed = to_seconds(simulation_->now() - began_at_) / options_.real_time_factor;
  const ros::WallTime due = *began_ + ros::WallDuration(elapsed);
  while (ros::ok() && began_ && ros::WallTime::now() < due) {
    serve((due - ros::WallTime::now()).toSec());
  }
}

bool RobotSimNode::reset(std_srvs::Trigger::Request& /*request*/,
                         std_srvs::Trigger::Response& response) {
  begin();
  response.success = 1;
  response.message = "begins anew";
  return true;
}

bool RobotSimNode::write_truth(std_srvs::Trigger::Request& /*request*/,
                               std_srvs::Trigger::Response& response) try {
  truth_->write(*simulation_);
  response.success = 1;
  response.message = "wrote the truth to " + options_.truth_directory;
  return true;
} catch (const std::exception& error) {
  response.success = 0;
  response.message = error.what();
  return true;
}

}  // namespace portolan::sim
