// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/octo/grounded_cloud.hpp"
#include "portolan/options.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// How the ground is told from obstacles; names and defaults of octomap_server.
struct GroundFilter {
  double distance = 0.04;
  double angle = 0.15;
  double plane_distance = 0.07;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("distance", self.distance, "points this near to the ground plane belong to it [m]",
          above(0.0));
    visit("angle", self.angle, "the plane may be tilted so much against the base's xy plane [rad]",
          between(0.0, 1.5));
    visit("plane_distance", self.plane_distance,
          "the plane passes the base's origin within this distance [m]", above(0.0));
  }
};

/// A plane: all p with normal . p + offset = 0, the normal of length 1 and pointing up.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;

  double height(const Eigen::Vector3d& p) const { return normal.dot(p) + offset; }
};

/// The ground plane in the base's frame: the plane with most points near to it of those that the
/// filter allows, by RANSAC with a fixed seed and a least squares fit to its points. None where
/// fewer than a hundredth of the points, or than 10, lie in any: the cloud shows no ground.
std::optional<Plane> find_ground(const PointCloud& cloud, const Pose& T_base_sensor,
                                 const GroundFilter& filter);

/// The cloud with the points near the ground plane set apart. Where no plane is found, what lies
/// within `distance` of the base's own xy plane counts as ground: a flat floor that is seen by a
/// few points still does not become an obstacle, and nothing that stands on it is lost.
GroundedCloud split_ground(const PointCloud& cloud, const Pose& T_base_sensor,
                           const GroundFilter& filter);

}  // namespace portolan
