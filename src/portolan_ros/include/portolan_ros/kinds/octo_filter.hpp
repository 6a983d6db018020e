// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "portolan/octo/cloud_filter.hpp"
#include "portolan/octo/ground_filter.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan_ros/convert/point_cloud.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// What a place of an organised cloud that holds NaN says.
enum class NanPoint {
  unknown,           ///< nothing, as REP 117 and 118 have it
  nothing_returned,  ///< nothing stood within reach, as drivers of many lidars mean it
};

constexpr std::array<const char*, 2> enum_names(NanPoint) {
  return {"unknown", "nothing_returned"};
}

/// What of a cloud enters the 3D map; names of octomap_server.
struct OctoFilterOptions {
  std::string pointcloud_frame;
  PassThrough box;
  NanPoint nan_points = NanPoint::unknown;
  bool thin_points = false;
  bool filter_ground = false;
  GroundFilter ground_filter;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("pointcloud_frame", self.pointcloud_frame,
          "frame in which pointcloud_min_x and its like count; empty: odom_frame. Not the map's: "
          "corrections must not change what enters");
    visit("pointcloud_min_x", self.box.min_x, "points behind this are dropped [m]");
    visit("pointcloud_max_x", self.box.max_x, "points ahead of this are dropped [m]");
    visit("pointcloud_min_y", self.box.min_y, "points to the right of this are dropped [m]");
    visit("pointcloud_max_y", self.box.max_y, "points to the left of this are dropped [m]");
    visit("pointcloud_min_z", self.box.min_z, "points below this are dropped [m]");
    visit("pointcloud_max_z", self.box.max_z, "points above this are dropped [m]");
    visit(
        "nan_points", self.nan_points,
        "what NaN in an organised cloud says; unknown: depth cameras mean too near by it as well. "
        "+Inf always says that nothing returned. Counts with no_return = clear");
    visit("thin_points", self.thin_points,
          "keep one point of a cloud in each cube of the map's resolution: less time and log");
    visit("filter_ground", self.filter_ground,
          "points of the ground plane clear the way to them and are no obstacles");
    visit("ground_filter", self.ground_filter, "how the ground is told from obstacles");
    visit.require(self.box.min_x < self.box.max_x && self.box.min_y < self.box.max_y &&
                      self.box.min_z < self.box.max_z,
                  "each pointcloud_min must be below its pointcloud_max");
  }
};

/// Takes out of clouds what shall not enter the 3D map, before the log keeps them.
class OctoFilter {
 public:
  using Options = OctoFilterOptions;

  OctoFilter(const Options& options, const PipelineOptions& pipeline,
             const OctoMapper::Options& mapper);

  /// The frames in which the sensor must be posed.
  std::vector<std::string> references(const ros_convert::OrganizedCloud& cloud) const;
  std::vector<std::string> references(const RangeScan& /*scan*/) const { return {}; }

  /// What enters of a cloud that was seen from there. Scans enter as they are.
  OctoMapper::Observation operator()(ros_convert::OrganizedCloud organized,
                                     const PosedInput::SensorPose& pose) const;
  OctoMapper::Observation operator()(RangeScan scan, const PosedInput::SensorPose& /*pose*/) const {
    return scan;
  }

 private:
  Options options_;
  bool passes_all_;
  std::string base_frame_;
  double cell_;   // [m], for thinning; 0: none
  double reach_;  // of rays that return nothing [m]
  NoReturn no_return_;
};

}  // namespace portolan
