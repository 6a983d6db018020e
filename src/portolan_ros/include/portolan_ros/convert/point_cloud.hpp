// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <optional>
#include <vector>

#include "portolan/observation/point_cloud.hpp"
#include "portolan_ros/sensed.hpp"

namespace portolan::ros_convert {

/// The finite points of a cloud with float32 or float64 fields x, y, z at any offset, in any byte
/// order, with any padding and further fields. None where a field is missing or the sizes that
/// the message states do not fit its data.
std::optional<Sensed<PointCloud>> point_cloud(const sensor_msgs::PointCloud2& message);

/// A cloud and, where it has rows and columns, the directions in which it holds no point.
struct OrganizedCloud {
  PointCloud cloud;                      ///< its `no_returns` are the places at +Inf
  std::vector<Eigen::Vector3f> unknown;  ///< the places that hold NaN
};

/// The same, and for a cloud in rows and columns the directions of the places that hold no finite
/// point. See `missing_directions`.
std::optional<Sensed<OrganizedCloud>> organized_cloud(const sensor_msgs::PointCloud2& message);

}  // namespace portolan::ros_convert
