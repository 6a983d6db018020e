// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <cstddef>
#include <string>

#include "portolan_ros/diagnosis.hpp"
#include "portolan_ros/graph/graph_keeper.hpp"
#include "portolan_ros/graph/graph_outputs.hpp"
#include "portolan_ros/graph/graph_pipeline.hpp"
#include "portolan_ros/graph/graph_services.hpp"
#include "portolan_ros/map_services.hpp"
#include "portolan_ros/subscriptions.hpp"

namespace portolan {

/// The node that finds how far odometry has drifted, so that all others can correct their maps.
class PoseGraphNode {
 public:
  /// Throws OptionsError with every fault of the parameters at once.
  PoseGraphNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

 private:
  void subscribe();
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status);
  void say_what_was_dropped();
  std::string map_name() const;

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  GraphNodeOptions options_;
  GraphPipeline pipeline_{options_};
  GraphOutputs outputs_{handle_, options_, pipeline_};
  GraphServices arcs_{private_handle_, pipeline_};
  GraphKeeper keeper_{pipeline_, options_};
  std::size_t dropped_ = 0;  // keyframes of which this was said
  Diagnosis diagnosis_;
  diagnostic_updater::Updater diagnostics_{handle_, private_handle_};
  Subscriptions subscriptions_{handle_};
  MapServices services_{
      private_handle_,
      {[this] { return keeper_.save(map_name()); }, [this] { return keeper_.load(map_name()); },
       [this] { return keeper_.reset(); }}};
  std::vector<ros::WallTimer> timers_;  // simulated time may stand still, or run back
};

}  // namespace portolan
