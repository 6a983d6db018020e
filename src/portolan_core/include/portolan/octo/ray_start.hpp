// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "portolan/octo/ray_walk.hpp"
#include "portolan/octo/voxel_lattice.hpp"

namespace portolan {

/// Where the rays of an observation begin: what they have in common is worked out once.
class RayStart {
 public:
  /// `origin`: a point of the map [m].
  RayStart(const VoxelLattice& lattice, const octomap::point3d& origin);

  const octomap::point3d& origin() const { return origin_; }

  /// The voxel that rays begin in; none beyond the octree.
  const std::optional<octomap::OcTreeKey>& key() const { return key_; }

  /// The walk to a point of the map [m] in the voxel `key_end`, in cells of these axes; none where
  /// the start lies beyond the octree or in the same voxel.
  std::optional<RayWalk> walk_to(const octomap::point3d& end, const octomap::OcTreeKey& key_end,
                                 const RayWalk::Axes& axes) const;

 private:
  octomap::point3d origin_;
  std::optional<octomap::OcTreeKey> key_;
  double resolution_;
  // To the borders of the first voxel, behind and before, along each axis [m].
  std::array<std::array<double, 3>, 2> to_border_{};
};

}  // namespace portolan
