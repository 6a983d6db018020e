// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace portolan {

/// Where a frame lies in another one: `T_a_b` takes the coordinates of b to those of a.
using Pose = Eigen::Isometry3d;

/// The pose of a planar robot: x, y [m] and heading [rad], z = 0.
Pose planar_pose(double x, double y, double yaw);

/// The heading of the x axis in the xy plane, in (-pi, pi] [rad].
double yaw(const Pose& pose);

/// The pose at `fraction` of the way from `a` (0) to `b` (1): straight in position, slerp in
/// orientation. Fractions outside [0, 1] extrapolate. At the ends, and between equal poses, exactly
/// these poses: where a correction stays, nothing moves by a rounding.
Pose interpolate(const Pose& a, const Pose& b, double fraction);

/// True where the rotation is one, to within 1e-6, and the translation finite and below 1e8 m.
bool is_valid(const Pose& pose);

/// The angle of the rotation, in [0, pi] [rad].
double rotation_angle(const Pose& pose);

/// The angle brought into (-pi, pi] [rad].
double wrap_angle(double angle);

}  // namespace portolan
