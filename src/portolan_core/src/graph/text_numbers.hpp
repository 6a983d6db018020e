// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// The text's number, whatever the locale of the process; none if it is not one finite number.
std::optional<double> number_in(const std::string& text);
std::optional<std::int64_t> integer_in(const std::string& text);
/// Seconds with at most nine decimals, to the nanosecond.
std::optional<Time> stamp_in(const std::string& text);

/// The value in 15 digits if these give it back exactly, else in 17.
std::string to_text(double value);
std::string to_text(Time stamp);

/// The heading, and the quaternion, of a pose in steps of 1e-14: what conversion there and back
/// rounds is far smaller, so that the pose that they give has the same ones.
double rounded_heading(const Pose& pose);
Eigen::Quaterniond rounded_quaternion(const Pose& pose);

/// The pose of a position and a quaternion that need not be normalised.
Pose spatial_pose(const Eigen::Vector3d& t, const Eigen::Quaterniond& q);

}  // namespace portolan
