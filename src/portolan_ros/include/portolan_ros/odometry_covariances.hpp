// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>

#include <map>
#include <optional>
#include <string>

#include "portolan/pose_covariance.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// How well odometry said it knew the robot's pose, by time.
class OdometryCovariances {
 public:
  /// What a message stated: `covariance` along and about the axes of the odometry frame, of the
  /// pose of `frame`.
  struct Stated {
    std::string frame;
    PoseCovariance covariance;
  };

  explicit OdometryCovariances(Duration remembered) : remembered_(remembered) {}

  /// Takes what a message says of the pose of `frame`. Zeros, and what is no covariance, say that
  /// nothing is known, and so do those in -1.
  void receive(const nav_msgs::Odometry& message, const std::string& frame);

  /// What the last message up to then stated; none where that did not say.
  std::optional<Stated> at(Time stamp) const;

  void clear() { stated_.clear(); }

 private:
  Duration remembered_;
  std::map<Time, std::optional<Stated>> stated_;
};

}  // namespace portolan
