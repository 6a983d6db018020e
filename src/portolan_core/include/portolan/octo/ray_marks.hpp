// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "portolan/octo/ray_start.hpp"
#include "portolan/octo/voxel_block.hpp"
#include "portolan/octo/walk_rays.hpp"

namespace portolan {

/// What one observation says of each voxel: crossed by a ray, or the end of one. Near the sensor
/// the marks lie in a dense volume, so that marking is one store; further away in a table. A copy
/// starts empty: marks are working memory, not part of a map.
///
/// The volume holds voxels row by row, so that a step along any axis is one addition to an address;
/// a byte a voxel where that is not too much memory, since bytes can be stored without reading them
/// first, and else a bit a voxel.
class RayMarks {
 public:
  /// The voxels that are to be marked, as keys, both ends included.
  struct Box {
    int min[3] = {VoxelLattice::kSide, VoxelLattice::kSide, VoxelLattice::kSide};
    int max[3] = {-1, -1, -1};

    void extend(const octomap::OcTreeKey& key) {
      for (unsigned i = 0; i < 3; ++i) {
        min[i] = std::min<int>(min[i], key[i]);
        max[i] = std::max<int>(max[i], key[i]);
      }
    }
    bool contains(int x, int y, int z) const {
      return x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1] && z >= min[2] && z <= max[2];
    }
    bool is_empty() const { return max[0] < min[0]; }
  };

  /// A volume of more voxels is marked by bits, one of more than `max_voxels` is not laid.
  struct Limits {
    std::int64_t byte_voxels = std::int64_t{1} << 22;
    std::int64_t max_voxels = std::int64_t{1} << 30;
  };

  RayMarks() = default;
  explicit RayMarks(Limits limits) : limits_(limits) {}
  RayMarks(const RayMarks& other) : limits_(other.limits_) {}
  RayMarks& operator=(const RayMarks& /*other*/) { return *this; }
  RayMarks(RayMarks&&) = default;
  RayMarks& operator=(RayMarks&&) = default;
  ~RayMarks() = default;

  /// Makes ready for marks in a box that is not empty. Where it is too large for a dense volume,
  /// that is laid around `centre`, and marks outside still count.
  void start(const Box& box, const octomap::OcTreeKey& centre);

  /// Marks what a ray to a point of the map [m] crosses before the voxel `key_end` that holds it.
  void mark_crossed(const RayStart& start, const octomap::point3d& end,
                    const octomap::OcTreeKey& key_end);
  void mark_end(const octomap::OcTreeKey& key);

  /// Calls visit(BlockKey, crossed, ends) for every block with a mark and forgets the marks.
  template <class Visit>
  void take(Visit visit) {
    const auto is_key = [](int b) { return b >= 0 && b < BlockKey::kSide; };
    walk_waiting();
    merge_sparse();
    Blocks at;
    for (at.z = 0; at.z < sides_.z; ++at.z) {
      for (at.y = 0; at.y < sides_.y; ++at.y) {
        for (at.x = 0; at.x < sides_.x; ++at.x) {
          const Blocks key{corner_.x + at.x, corner_.y + at.y, corner_.z + at.z};
          Marks marks;
          if (take_block(at, marks) && is_key(key.x) && is_key(key.y) && is_key(key.z)) {
            visit(block_key(key.x, key.y, key.z), marks.crossed, marks.ends);
          }
        }
      }
    }
    for (const auto& [packed, marks] : sparse_) {
      visit(unpacked(packed), marks.crossed, marks.ends);
    }
    sparse_.clear();
  }

 private:
  struct Marks {
    VoxelMask crossed{};
    VoxelMask ends{};
  };
  struct Blocks {
    int x = 0;
    int y = 0;
    int z = 0;
  };
  static std::uint64_t packed(BlockKey key);
  static BlockKey unpacked(std::uint64_t packed);

  void lay_volume(const Box& dense);
  bool is_in_volume(const octomap::OcTreeKey& key) const {
    return dense_.contains(key[0], key[1], key[2]);
  }
  void walk_waiting();
  void mark_crossed_sparse(RayWalk::Cell cell);
  void merge_sparse();
  bool take_block(const Blocks& at, Marks& marks);
  std::size_t index(const Blocks& at) const {
    return static_cast<std::size_t>(at.x + std::int64_t{sides_.x} *
                                               (at.y + std::int64_t{sides_.y} * at.z));
  }
  RayWalk::Cell first_of(const Blocks& at) const {
    return axes_.cell(BlockKey::kVoxels * at.x, BlockKey::kVoxels * at.y, BlockKey::kVoxels * at.z);
  }

  Limits limits_;
  Box dense_;      // voxels whose rays stay in the volume
  Blocks corner_;  // the volume's first block; -1 where rays may lead out of the octree
  Blocks sides_;
  bool has_bytes_ = true;
  RayWalk::Axes axes_;                // of places in the volume: the cells of near rays,
  RayWalk::Cell first_ = 0;           // counted from this one
  std::vector<std::uint64_t> marks_;  // of crossed voxels: 8 bytes or 64 bits; 0 when idle
  std::vector<VoxelMask> ends_;       // by block; 0 when idle
  std::vector<RayWalk> near_, far_;   // rays that wait to be walked in the volume, or across it
  std::unordered_map<std::uint64_t, Marks> sparse_;  // by packed BlockKey
};

}  // namespace portolan
