// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_services.hpp"

#include <ros/console.h>
#include <ros/time.h>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

constexpr SensorId kFirstWord = 0x80000000;  // beyond all sensors of the robot

Eigen::Vector3d vector(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }

}  // namespace

OctoServices::OctoServices(ros::NodeHandle& private_handle, Remapper<OctoMapper>& map)
    : map_(map), next_word_(kFirstWord) {
  const boost::function<bool(Query::Request&, Query::Response&)> answer =
      [this](Query::Request& request, Query::Response&) { return clear(request); };
  server_ = private_handle.advertiseService("clear_bbx", answer);
}

bool OctoServices::clear(const Query::Request& request) {
  const ClearBox box{{vector(request.min), vector(request.max)}};
  const Time now = ros_convert::time(ros::Time::now());
  const Pose T_odom_map = map_.correction().at(now).inverse();
  // A sensor of its own each time: thinning must not turn it away.
  const auto outcome = map_.observe(now, T_odom_map, box, next_word_++);
  const bool cleared = outcome && *outcome == Outcome::inserted;
  if (!cleared) ROS_ERROR("clear_bbx: the box is none; min must be below max");
  return cleared;
}

}  // namespace portolan
