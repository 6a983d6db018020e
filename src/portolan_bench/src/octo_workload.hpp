// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "portolan/observation/point_cloud.hpp"
#include "portolan/pose.hpp"

namespace portolan::bench {

/// The directions in which a sensor looks, in its frame.
using Directions = std::vector<Eigen::Vector3d>;

/// A building of boxes.
struct BoxWorld {
  Eigen::AlignedBox3d inside;
  std::vector<Eigen::AlignedBox3d> boxes;

  /// The distance to what a ray meets [m].
  double cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
};

/// A sensor that is carried through a building.
struct OctoScene {
  std::string name;
  BoxWorld world;
  Directions directions;
  double resolution;  ///< [m]
  double max_range;   ///< [m]
  double spacing;     ///< from cloud to cloud [m]
};

struct PosedCloud {
  PointCloud cloud;
  Pose T_map_sensor;
};

/// A VLP-16 (30,000 points) in rooms and in halls, and a depth camera (307,200) in rooms.
std::vector<OctoScene> octo_scenes();

/// A VLP-16 in a street of 20 m, which goes on for ever, with a pillar every 10 m; 2 m from cloud
/// to cloud.
OctoScene street_scene();

/// The i-th cloud of the way along the street.
PosedCloud street_cloud(const OctoScene& scene, int i);

/// The i-th cloud of the way, with a noise of 1 cm; always the same.
PosedCloud octo_cloud(const OctoScene& scene, int i);

}  // namespace portolan::bench
