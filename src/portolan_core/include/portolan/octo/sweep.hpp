// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "portolan/observation/point_cloud.hpp"
#include "portolan/observation/range_reading.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/octo/grounded_cloud.hpp"
#include "portolan/octo/point_counts.hpp"
#include "portolan/octo/sensor_model.hpp"
#include "portolan/octo/voxel_lattice.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// The rays of one observation in the map, cut to the range that counts: from where to where, and
/// whether something stood at the end.
class Sweep {
 public:
  struct Ray {
    octomap::point3d origin;  ///< in the map [m]
    octomap::point3d end;     ///< in the map [m]
    bool hit;
    std::optional<octomap::OcTreeKey> key;  ///< the voxel of its end; none beyond the octree
  };

  /// `discretize`: one ray for each voxel with points in it, to its centre.
  Sweep(const VoxelLattice& lattice, const SensorModel& model, NoReturn no_return, bool discretize)
      : lattice_(lattice), model_(model), no_return_(no_return), discretize_(discretize) {}

  void add(const PointCloud& cloud, const Pose& T_map_sensor);
  void add(const GroundedCloud& cloud, const Pose& T_map_sensor);
  void add(const RangeScan& scan, const Pose& T_map_sensor);

  const std::vector<Ray>& rays() const { return rays_; }
  const PointCounts& counts() const { return counts_; }

 private:
  enum class Kind { obstacle, ground };

  void add_points(const std::vector<Eigen::Vector3f>& points, const Pose& T_map_sensor, Kind kind);
  void add_point(const octomap::point3d& origin, const octomap::point3d& p_map, Kind kind);
  void add_free(const octomap::point3d& origin, const octomap::point3d& end) {
    rays_.push_back({origin, end, false, lattice_.key(end)});
  }
  void add_no_return(const Pose& T_map_sensor, const Eigen::Vector3f& direction, double reach);
  void add_beam(const RangeScan& scan, double angle, double range, const Pose& T_map_beam);

  VoxelLattice lattice_;
  SensorModel model_;
  NoReturn no_return_;
  bool discretize_;
  std::vector<Ray> rays_;
  PointCounts counts_;
};

/// A point of the sensor's frame in the map, rounded once, at the end [m].
octomap::point3d to_map(const Pose& T_map_sensor, const Eigen::Vector3f& p_sensor);

}  // namespace portolan
