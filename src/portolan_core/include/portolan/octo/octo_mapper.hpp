// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <optional>
#include <variant>

#include "portolan/octo/clear_box.hpp"
#include "portolan/octo/grounded_cloud.hpp"
#include "portolan/octo/ray_marks.hpp"
#include "portolan/octo/sweep.hpp"
#include "portolan/octo/voxel_blocks.hpp"
#include "portolan/options.hpp"
#include "portolan/outcome.hpp"

namespace portolan {

/// Where something stands in space, where nothing does, and what has not been seen: a 3D map of
/// voxels, drawn by rays (section 2 of the chapter, with Eq. 8's log-odds and clamping).
///
/// It holds what octomap::OcTree::insertPointCloud would make of the same points, voxel by voxel
/// and bit by bit, but keeps it in hashed blocks; `OctreeMirror` and `octree` make the tree of it.
class OctoMapper {
 public:
  struct Options {
    double resolution = 0.05;
    SensorModel sensor_model;
    double occupancy_threshold = 0.5;
    bool discretize = false;
    NoReturn no_return = NoReturn::ignore;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("resolution", self.resolution, "side of a voxel [m]", within(1e-4, 1e3));
      visit("sensor_model", self.sensor_model, "what a ray tells of the voxels that it meets");
      visit("occupancy_threshold", self.occupancy_threshold,
            "a voxel is occupied from this probability on", between(0.0, 1.0));
      visit("discretize", self.discretize,
            "draw one ray for each voxel with points of a cloud in it, instead of one a point");
      visit("no_return", self.no_return, "where nothing came back: free up to the maximum range?");
      visit.require(
          self.no_return == NoReturn::ignore || self.sensor_model.max_range > 0.0,
          "no_return = clear needs sensor_model/max_range, the distance up to which to clear");
    }
  };

  using Observation = std::variant<PointCloud, RangeScan, GroundedCloud, ClearBox>;
  using Revision = VoxelBlocks::Revision;

  explicit OctoMapper(const Options& options);  ///< throws OptionsError

  /// The same, starting from these voxels instead of nothing.
  OctoMapper(const Options& options, VoxelBlocks blocks);

  /// Takes what a sensor at `T_map_sensor` saw. Within one observation each voxel changes at most
  /// once, and ends of rays win over rays that pass. `rejected`: the pose is none. `unusable`: a
  /// scan without sensible angles and limits, a box without extent.
  Outcome insert(const Observation& z, const Pose& T_map_sensor);

  const Options& options() const { return options_; }
  const VoxelLattice& lattice() const { return lattice_; }
  const VoxelBlocks& blocks() const { return blocks_; }

  /// Counts the observations that were inserted.
  Revision revision() const { return revision_; }

  /// What became of all points so far.
  const PointCounts& counts() const { return counts_; }

  /// The log-odds of the voxel at a point of the map; none where nothing is known.
  std::optional<float> log_odds(const octomap::point3d& p_map) const;

  /// From these log-odds on a voxel is occupied.
  float threshold_log_odds() const { return octomap::logodds(options_.occupancy_threshold); }

  /// A box around all that changed after the map had this revision [m]; none where nothing did.
  std::optional<Eigen::AlignedBox3d> changed_since(Revision revision) const;

 private:
  Outcome draw(const ClearBox& box, const Pose& T_map_box);
  Outcome draw(const RangeScan& scan, const Pose& T_map_sensor);
  template <class Cloud>
  Outcome draw(const Cloud& cloud, const Pose& T_map_sensor);
  void draw(const Sweep& sweep);

  Options options_;
  VoxelLattice lattice_;
  LogOddsModel model_;
  VoxelBlocks blocks_;
  RayMarks marks_;
  Revision revision_ = 0;
  PointCounts counts_;
};

/// What an observation of it occupies in memory [byte].
inline std::size_t byte_size(const OctoMapper::Observation& z) {
  return std::visit([](const auto& observation) { return byte_size(observation); }, z);
}

/// What the map occupies in memory [byte].
inline std::size_t byte_size(const OctoMapper& map) { return map.blocks().byte_size(); }

}  // namespace portolan
