// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_filter.hpp"

#include <utility>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

bool passes_all(const PassThrough& box) {
  const PassThrough any;
  return box.min_x == any.min_x && box.max_x == any.max_x && box.min_y == any.min_y &&
         box.max_y == any.max_y && box.min_z == any.min_z && box.max_z == any.max_z;
}

}  // namespace

OctoFilter::OctoFilter(const Options& options, const PipelineOptions& pipeline,
                       const OctoMapper::Options& mapper)
    : options_(options),
      passes_all_(passes_all(options.box)),
      base_frame_(ros_convert::without_slash(pipeline.base_frame)),
      cell_(options.thin_points ? mapper.resolution : 0.0),
      reach_(mapper.sensor_model.max_range),
      no_return_(mapper.no_return) {
  if (options_.pointcloud_frame.empty()) options_.pointcloud_frame = pipeline.posing.odom_frame;
  options_.pointcloud_frame = ros_convert::without_slash(options_.pointcloud_frame);
}

std::vector<std::string> OctoFilter::references(
    const ros_convert::OrganizedCloud& /*cloud*/) const {
  std::vector<std::string> frames;
  if (!passes_all_) frames.push_back(options_.pointcloud_frame);
  if (options_.filter_ground) frames.push_back(base_frame_);
  return frames;
}

OctoMapper::Observation OctoFilter::operator()(ros_convert::OrganizedCloud organized,
                                               const PosedInput::SensorPose& pose) const {
  PointCloud& cloud = organized.cloud;
  const std::vector<Pose>& T_reference_sensor = pose.T_reference_sensor;
  if (no_return_ == NoReturn::ignore) {
    cloud.no_returns = {};  // the log need not keep them
  } else if (options_.nan_points == NanPoint::nothing_returned) {
    cloud.no_returns.insert(cloud.no_returns.end(), organized.unknown.begin(),
                            organized.unknown.end());
  }
  if (!passes_all_) {
    cloud = pass_through(std::move(cloud), T_reference_sensor.front(), options_.box);
  }
  cloud = thinned(std::move(cloud), cell_, reach_);
  if (!options_.filter_ground) return std::move(cloud);
  return split_ground(cloud, T_reference_sensor.back(), options_.ground_filter);
}

}  // namespace portolan
