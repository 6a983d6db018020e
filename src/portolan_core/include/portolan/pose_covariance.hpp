// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/pose.hpp"

namespace portolan {

/// How well a pose is known: the covariance of the errors of its position [m], then of small
/// rotations [rad], along and about three axes that go with it.
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// The same covariance along and about other axes: `R_b_a` takes the coordinates of those before.
PoseCovariance turned(const PoseCovariance& covariance, const Eigen::Matrix3d& R_b_a);

/// Of the pose of a thing that is fixed to another one, `arm` [m] away from it, in the same axes.
PoseCovariance carried(const PoseCovariance& covariance, const Eigen::Vector3d& arm);

/// True where it says something: finite, symmetric, no variance negative, and not all of it zero.
bool is_stated(const PoseCovariance& covariance);

/// The same as far as it can be meant: variances no wider than the limits of `limits.hpp`, and
/// none below zero along any axis, as rounding leaves them. 1e6 for "unknown" is in use.
PoseCovariance believable(const PoseCovariance& covariance);

/// The matrix of v cross.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);

}  // namespace portolan
