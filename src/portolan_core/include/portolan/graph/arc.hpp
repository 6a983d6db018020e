// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "portolan/pose.hpp"

namespace portolan {

/// Names a pose of a graph: a keyframe's number, any and with gaps.
using PoseId = std::int64_t;

/// What an arc was deduced from.
enum class ArcKind {
  odometry,  ///< motion from one keyframe to the next
  scan,      ///< match of neighbouring keyframes
  loop,      ///< match of keyframes that met again
  given,     ///< told from outside
};

constexpr std::array<const char*, 4> enum_names(ArcKind) {
  return {"odometry", "scan", "loop", "given"};
}

/// Whether an arc takes part in the coordinates. Only accepted ones do.
enum class ArcState {
  accepted,
  rejected,  ///< found wrong or useless, and kept to show why
  disabled,  ///< taken out by request
};

constexpr std::array<const char*, 3> enum_names(ArcState) {
  return {"accepted", "rejected", "disabled"};
}

/// Why an arc is in its state.
enum class ArcReason {
  none,
  by_request,
  low_overlap,      ///< the observations at its ends share too little
  poor_match,       ///< they share enough, but do not fit
  degenerate,       ///< they leave a direction open, as in a corridor
  ambiguous,        ///< they fit in several places
  inconsistent,     ///< it contradicts the arcs around it
  bad_information,  ///< its information is not finite, not symmetric or has negative eigenvalues
  unconfirmed,      ///< it fits, but too few other arcs say the same yet
};

constexpr std::array<const char*, 9> enum_names(ArcReason) {
  return {"none",      "by_request",   "low_overlap",     "poor_match", "degenerate",
          "ambiguous", "inconsistent", "bad_information", "unconfirmed"};
}

/// What may move between two poses: x, y, z [m], then a turn about x, y, z [rad], as in ROS and
/// g2o. T * exp(v): v is in the frame that T leads from, at the arc's far end.
using Tangent = Eigen::Matrix<double, 6, 1>;
/// Covariance or information of a `Tangent`.
using TangentMatrix = Eigen::Matrix<double, 6, 6>;

/// A measured relative pose of two poses of a graph, with a Gaussian: chapter 8's arc.
/// Its residual is [t; 2 vec(q)] of T_from_to^-1 * (T_map_from^-1 * T_map_to), where the quaternion
/// q has w >= 0; in the plane [x; y; heading] of the same. chi^2 = residual^T information residual.
struct Arc {
  PoseId from = 0;
  PoseId to = 0;
  Pose T_from_to = Pose::Identity();
  /// Inverse covariance of the residual; in the plane only rows and columns 0, 1 and 5 count.
  /// Zero in directions of which nothing is known.
  TangentMatrix information = TangentMatrix::Identity();
  ArcKind kind = ArcKind::given;
  ArcState state = ArcState::accepted;
  ArcReason reason = ArcReason::none;
};

}  // namespace portolan
