// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "portolan/octo/voxel_lattice.hpp"
#include "portolan/sim/any_sensor.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// What lidars and depth cameras could have seen of space so far, voxel by voxel: free where a ray
/// passed, a surface where it ended. Found by small steps along exact rays, as nobody would map.
class VolumeView {
 public:
  enum class Voxel : std::uint8_t { unseen, free, surface };

  /// Over a box of space; no ray is followed further than `reach` [m].
  VolumeView(const VoxelLattice& lattice, const Eigen::AlignedBox3d& space, double reach);

  /// Adds what the sensor sees from there without noise. A place less than `spacing` [m] and 0.3
  /// rad from the last one that the same sensor looked from adds nothing.
  void look(const World& world, const AnySensor& sensor, const Pose& T_map_base, double spacing);

  /// Calls visit(centre [m], voxel) for each voxel that was seen.
  template <class Visit>
  void for_each_seen(Visit visit) const {
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
      if (voxels_[i] != Voxel::unseen) visit(centre(i), voxels_[i]);
    }
  }

 private:
  template <class Sensor>
  void look_with(const World& world, typename Sensor::Options options, const Pose& T_map_base);
  void look_along(const Pose& T_map_sensor, const Eigen::Vector3d& p_sensor, bool returns);
  void mark(const Eigen::Vector3d& p_map, Voxel what);
  Eigen::Vector3d centre(std::size_t i) const;

  double side_;  // of a voxel [m]
  double reach_;
  Eigen::Array3i low_;   // the box's lowest voxel, counted from the map's origin
  Eigen::Array3i size_;  // in voxels
  std::vector<Voxel> voxels_;
  std::map<std::string, Pose> looked_from_;  // by frame of the sensor
};

}  // namespace portolan::sim
