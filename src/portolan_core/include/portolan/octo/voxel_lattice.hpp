// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <optional>

namespace portolan {

/// The cubes that an octree of 16 levels divides space into: 65536 along each axis, the origin of
/// the map at the corner of the middle one. Arithmetic as in octomap::OcTree, to the last bit, but
/// defined for every number.
class VoxelLattice {
 public:
  static constexpr int kSide = 65536;        ///< voxels along an axis
  static constexpr int kMiddle = kSide / 2;  ///< the key of the voxel just above 0

  /// `resolution`: the side of a voxel [m].
  explicit VoxelLattice(double resolution)
      : resolution_(resolution), voxels_per_metre_(1.0 / resolution) {}

  double resolution() const { return resolution_; }

  /// The voxel that holds a point of the map [m]; none beyond the octree and for NaN.
  std::optional<octomap::OcTreeKey> key(const octomap::point3d& p_map) const {
    octomap::OcTreeKey key;
    for (unsigned i = 0; i < 3; ++i) {
      const double place = voxels_per_metre_ * static_cast<double>(p_map(i));
      if (!(place >= -kMiddle && place < kMiddle)) return std::nullopt;
      key[i] = static_cast<octomap::key_type>(floor(place) + kMiddle);
    }
    return key;
  }

  /// The coordinate of the centre of a voxel on one axis [m].
  double centre(int key) const { return (static_cast<double>(key - kMiddle) + 0.5) * resolution_; }

  /// The centre of a voxel [m].
  octomap::point3d centre(const octomap::OcTreeKey& key) const {
    return {static_cast<float>(centre(key[0])), static_cast<float>(centre(key[1])),
            static_cast<float>(centre(key[2]))};
  }

 private:
  static int floor(double x) {
    const int towards_zero = static_cast<int>(x);
    return towards_zero - (towards_zero > x ? 1 : 0);
  }

  double resolution_;
  double voxels_per_metre_;
};

}  // namespace portolan
