// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/LandmarkMap.h>
#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "portolan/landmark/landmark_mapper.hpp"
#include "portolan/options.hpp"
#include "portolan/remapper.hpp"
#include "portolan_ros/kinds/whole_map_topic.hpp"

namespace portolan {

/// How a map of landmarks leaves the node.
struct LandmarkOutputOptions {
  double marker_stddevs = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("marker_stddevs", self.marker_stddevs,
          "half axes of the ellipsoids on `landmarks_vis`, in standard deviations", above(0.0));
  }
};

/// The topics of the map of landmarks: `landmarks` and `landmarks_vis`, both latched.
class LandmarkOutputs {
 public:
  LandmarkOutputs(ros::NodeHandle& handle, const LandmarkOutputOptions& options,
                  const std::string& map_frame, const Remapper<LandmarkMapper>& source);
  LandmarkOutputs(const LandmarkOutputs&) = delete;  // the topics call back into this object
  LandmarkOutputs& operator=(const LandmarkOutputs&) = delete;

  void publish(const ros::Time& stamp);

 private:
  portolan_msgs::LandmarkMap map() const;

  const Remapper<LandmarkMapper>& source_;
  std::string map_frame_;
  ros::Time stamp_;
  WholeMapTopic<portolan_msgs::LandmarkMap> landmarks_;
  WholeMapTopic<visualization_msgs::MarkerArray> markers_;
};

}  // namespace portolan
