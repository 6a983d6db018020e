// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/BeaconMap.h>
#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/options.hpp"
#include "portolan/remapper.hpp"
#include "portolan_ros/kinds/whole_map_topic.hpp"

namespace portolan {

/// How a map of beacons leaves the node.
struct BeaconOutputOptions {
  double marker_stddevs = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("marker_stddevs", self.marker_stddevs,
          "half axes of the ellipsoids on `beacons_vis`, in standard deviations", above(0.0));
  }
};

/// The topics of the map of beacons: `beacons` and `beacons_vis`, both latched.
class BeaconOutputs {
 public:
  BeaconOutputs(ros::NodeHandle& handle, const BeaconOutputOptions& options,
                const std::string& map_frame, const Remapper<BeaconMapper>& source);
  BeaconOutputs(const BeaconOutputs&) = delete;  // the topics call back into this object
  BeaconOutputs& operator=(const BeaconOutputs&) = delete;

  void publish(const ros::Time& stamp);

 private:
  portolan_msgs::BeaconMap map() const;

  const Remapper<BeaconMapper>& source_;
  std::string map_frame_;
  ros::Time stamp_;
  WholeMapTopic<portolan_msgs::BeaconMap> beacons_;
  WholeMapTopic<visualization_msgs::MarkerArray> markers_;
};

}  // namespace portolan
