// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/beacon_outputs.hpp"

#include "portolan_ros/convert/beacon_markers.hpp"
#include "portolan_ros/convert/beacons.hpp"

namespace portolan {

BeaconOutputs::BeaconOutputs(ros::NodeHandle& handle, const BeaconOutputOptions& options,
                             std::string map_frame, const Remapper<BeaconMapper>& source)
    : source_(source), options_(options), map_frame_(std::move(map_frame)) {
  const ros::SubscriberStatusCallback came = [this](const ros::SingleSubscriberPublisher&) {
    someone_came_ = true;
  };
  const ros::SubscriberStatusCallback left;
  beacons_ = handle.advertise<portolan_msgs::BeaconMap>("beacons", 1, came, left, {}, true);
  markers_ =
      handle.advertise<visualization_msgs::MarkerArray>("beacons_vis", 1, came, left, {}, true);
}

void BeaconOutputs::publish(const ros::Time& stamp) {
  const bool map_wanted = beacons_.getNumSubscribers() > 0;
  const bool markers_wanted = markers_.getNumSubscribers() > 0;
  if (!map_wanted && !markers_wanted) return;
  if (!someone_came_ && version() == published_) return;
  someone_came_ = false;
  published_ = version();
  portolan_msgs::BeaconMap map = ros_convert::beacon_map(source_.map());
  map.header.stamp = stamp;
  map.header.frame_id = map_frame_;
  if (map_wanted) beacons_.publish(map);
  if (markers_wanted) {
    markers_.publish(ros_convert::beacon_markers(map, options_.marker_stddevs));
  }
}

BeaconOutputs::Version BeaconOutputs::version() const {
  const BeaconCounts& counts = source_.map().counts();
  return {source_.generation(), counts.taken + counts.malformed + counts.too_long + counts.refused};
}

}  // namespace portolan
