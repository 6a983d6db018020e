// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_pipeline.hpp"

#include <utility>

#include "portolan_ros/convert/ranges.hpp"

namespace portolan {

GraphPipeline::GraphPipeline(const GraphNodeOptions& options)
    : options_(checked(options)),
      posed_(options.posing),
      scans_(posed_.add_input("scans")),
      graph_(options.graph) {}

void GraphPipeline::receive_scan(const sensor_msgs::LaserScan& message, Time now) {
  poll(now);
  auto sensed = ros_convert::range_scan(message);
  if (!sensed) return posed_.receive_malformed(scans_);
  PosedInput::Message waiting{sensed->frame, sensed->first, sensed->last, {}, {}, sensed->part};
  waiting.references = {options_.base_frame};
  waiting.use = [this, stamp = sensed->first,
                 z = std::move(sensed->z)](const PosedInput::SensorPose& pose) mutable {
    z.T_first_last = pose.T_first_last;
    const Pose& T_base_sensor = pose.T_reference_sensor.front();
    return graph_.insert(stamp, pose.T_odom_sensor * T_base_sensor.inverse(), z, T_base_sensor);
  };
  posed_.receive(scans_, std::move(waiting), now);
}

void GraphPipeline::receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now) {
  check_clock(now);
  posed_.receive_tf(message, is_static, now);
  check_transforms();
  posed_.poll(now);
}

void GraphPipeline::receive_odometry(const nav_msgs::Odometry& message, Time now) {
  check_clock(now);
  posed_.receive_odometry(message, options_.base_frame, now);
  check_transforms();
  posed_.poll(now);
}

void GraphPipeline::receive_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message,
                                         Time now) {
  poll(now);
  initial_poses_.receive(message, now, graph_);
}

void GraphPipeline::poll(Time now) {
  check_clock(now);
  posed_.poll(now);
}

void GraphPipeline::restart_from(PoseGraph graph) {
  graph_ = std::move(graph);
  ++restarts_;
}

void GraphPipeline::check_clock(Time now) {
  if (!clock_.ran_back(now)) return;
  posed_.clear();
  ++time_jumps_;
  reset();
}

void GraphPipeline::check_transforms() {
  if (!posed_.transforms_ran_back()) return;
  ++time_jumps_;
  reset();
}

}  // namespace portolan
