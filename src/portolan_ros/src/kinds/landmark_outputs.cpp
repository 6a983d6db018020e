// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/landmark_outputs.hpp"

#include "portolan_ros/convert/landmark_markers.hpp"
#include "portolan_ros/convert/landmarks.hpp"

namespace portolan {

LandmarkOutputs::LandmarkOutputs(ros::NodeHandle& handle, const LandmarkOutputOptions& options,
                                 const std::string& map_frame,
                                 const Remapper<LandmarkMapper>& source)
    : source_(source),
      map_frame_(map_frame),
      landmarks_(handle, "landmarks", 0.0, [this] { return map(); }),
      markers_(handle, "landmarks_vis", 0.0, [this, stddevs = options.marker_stddevs] {
        return ros_convert::landmark_markers(map(), stddevs);
      }) {}

void LandmarkOutputs::publish(const ros::Time& stamp) {
  stamp_ = stamp;
  // From 1, so that an empty map is published too.
  const std::uint64_t revision = source_.map().revision() + 1;
  landmarks_.publish({source_.generation(), revision});
  markers_.publish({source_.generation(), revision});
}

portolan_msgs::LandmarkMap LandmarkOutputs::map() const {
  portolan_msgs::LandmarkMap message = ros_convert::landmark_map(source_.map());
  message.header.stamp = stamp_;
  message.header.frame_id = map_frame_;
  return message;
}

}  // namespace portolan
