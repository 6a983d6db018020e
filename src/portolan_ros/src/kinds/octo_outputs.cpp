// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_outputs.hpp"

#include <stdexcept>
#include <utility>

#include "portolan_ros/convert/octomap.hpp"

namespace portolan {

OctoOutputs::OctoOutputs(ros::NodeHandle& handle, const OctoOutputOptions& options,
                         const std::string& map_frame, const Remapper<OctoMapper>& source)
    : options_(options),
      map_frame_(map_frame),
      source_(source),
      mirror_(source.map().options()),
      projection_(Shown{options.projected(), options.filter_speckles}),
      markers_(Shown{options.occupancy, options.filter_speckles}, options.colour_period),
      markers_publisher_(advertise_markers(handle)),
      binary_(handle, "octomap_binary", options.tree_interval, [this] { return binary(); }),
      full_(handle, "octomap_full", options.tree_interval, [this] { return full(); }),
      centers_(handle, "octomap_point_cloud_centers", options.tree_interval,
               [this] { return centers(); }),
      projected_(handle, "projected_map", 0.0, [this] { return projected(); }),
      services_{{advertise_tree(handle, "octomap_binary", &OctoOutputs::binary),
                 advertise_tree(handle, "octomap_full", &OctoOutputs::full)}} {}

void OctoOutputs::publish(const ros::Time& stamp) {
  publish_markers(stamp);
  projected_.publish({source_.generation(), source_.map().revision()});
  centers_.publish({source_.generation(), source_.map().revision()});
  binary_.publish({source_.generation(), source_.map().revision()});
  full_.publish({source_.generation(), source_.map().revision()});
}

OctoOutputs::Octomap OctoOutputs::binary() { return stamped(ros_convert::octomap_binary(tree())); }

OctoOutputs::Octomap OctoOutputs::full() { return stamped(ros_convert::octomap_full(tree())); }

sensor_msgs::PointCloud2 OctoOutputs::centers() const {
  const OctoMapper& map = source_.map();
  return stamped(ros_convert::voxel_centers(
      occupied_voxels(map, {options_.occupancy, options_.filter_speckles}), map.lattice()));
}

nav_msgs::OccupancyGrid OctoOutputs::projected() {
  projection_.follow(source_.map(), source_.generation());
  if (projection_.area() > options_.max_cells) {
    throw std::runtime_error("projected_map is too large to publish: " +
                             std::to_string(projection_.area()) + " cells; see ~max_cells");
  }
  nav_msgs::OccupancyGrid message = stamped(ros_convert::projected_map(projection_.grid()));
  if (message.data.empty()) {
    // An empty map is shown as the last one with nothing known: no one can show zero cells.
    message.info = projected_info_;
    message.data.assign(std::size_t{message.info.width} * message.info.height, -1);
  }
  message.info.map_load_time = message.header.stamp;
  projected_info_ = message.info;
  return message;
}

void OctoOutputs::publish_markers(const ros::Time& stamp) {
  if (markers_publisher_.getNumSubscribers() == 0) return;
  visualization_msgs::MarkerArray message = markers_.changes(source_.map(), source_.generation());
  if (message.markers.empty()) return;
  for (visualization_msgs::Marker& marker : message.markers) {
    marker.header.stamp = stamp;
    marker.header.frame_id = map_frame_;
  }
  markers_publisher_.publish(message);
}

ros::Publisher OctoOutputs::advertise_markers(ros::NodeHandle& handle) {
  const ros::SubscriberStatusCallback came = [this](const ros::SingleSubscriberPublisher&) {
    markers_.forget();
  };
  return handle.advertise<visualization_msgs::MarkerArray>("occupied_cells_vis_array", 100, came);
}

ros::ServiceServer OctoOutputs::advertise_tree(ros::NodeHandle& handle, const std::string& name,
                                               Octomap (OctoOutputs::*make)()) {
  const boost::function<bool(GetOctomap::Request&, GetOctomap::Response&)> answer =
      [this, make](GetOctomap::Request&, GetOctomap::Response& response) {
        response.map = (this->*make)();
        return true;
      };
  return handle.advertiseService(name, answer);
}

const octomap::OcTree& OctoOutputs::tree() {
  mirror_.follow(source_.map(), source_.generation());
  return mirror_.tree();
}

template <class Message>
Message OctoOutputs::stamped(Message message) const {
  message.header.stamp = ros::Time::now();
  message.header.frame_id = map_frame_;
  return message;
}

}  // namespace portolan
