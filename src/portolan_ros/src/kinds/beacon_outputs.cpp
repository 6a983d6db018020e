// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/beacon_outputs.hpp"

#include "portolan_ros/convert/beacon_markers.hpp"
#include "portolan_ros/convert/beacons.hpp"

namespace portolan {

BeaconOutputs::BeaconOutputs(ros::NodeHandle& handle, const BeaconOutputOptions& options,
                             const std::string& map_frame, const Remapper<BeaconMapper>& source)
    : source_(source),
      map_frame_(map_frame),
      beacons_(handle, "beacons", 0.0, [this] { return map(); }),
      markers_(handle, "beacons_vis", 0.0, [this, stddevs = options.marker_stddevs] {
        return ros_convert::beacon_markers(map(), stddevs);
      }) {}

void BeaconOutputs::publish(const ros::Time& stamp) {
  stamp_ = stamp;
  // From 1, so that an empty map is published too.
  const BeaconCounts& counts = source_.map().counts();
  const std::uint64_t revision =
      1 + counts.taken + counts.malformed + counts.too_long + counts.refused;
  beacons_.publish({source_.generation(), revision});
  markers_.publish({source_.generation(), revision});
}

portolan_msgs::BeaconMap BeaconOutputs::map() const {
  portolan_msgs::BeaconMap message = ros_convert::beacon_map(source_.map());
  message.header.stamp = stamp_;
  message.header.frame_id = map_frame_;
  return message;
}

}  // namespace portolan
