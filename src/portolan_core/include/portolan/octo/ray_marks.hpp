// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "portolan/octo/voxel_block.hpp"
#include "portolan/octo/walk_rays.hpp"

namespace portolan {

/// What one observation says of each voxel, as bits: crossed by a ray, or the end of one. Near the
/// sensor the bits lie in a dense volume, so that marking is one store; further away in a table.
/// A copy starts empty: marks are working memory, not part of a map.
class RayMarks {
 public:
  /// The voxels that are to be marked, as keys, both ends included.
  struct Box {
    int min[3] = {VoxelLattice::kSide, VoxelLattice::kSide, VoxelLattice::kSide};
    int max[3] = {-1, -1, -1};

    void extend(const octomap::OcTreeKey& key);
    bool contains(int x, int y, int z) const;
    bool is_empty() const { return max[0] < min[0]; }
  };

  RayMarks() = default;
  RayMarks(const RayMarks& /*other*/) {}
  RayMarks& operator=(const RayMarks& /*other*/) { return *this; }
  RayMarks(RayMarks&&) = default;
  RayMarks& operator=(RayMarks&&) = default;
  ~RayMarks() = default;

  /// Makes ready for marks in a box that is not empty. Where it is too large for a dense volume,
  /// that is laid around `centre`, and marks outside still count.
  void start(const Box& box, const octomap::OcTreeKey& centre);

  void mark_crossed(const RayWalk& ray);
  void mark_end(const octomap::OcTreeKey& key);

  /// Calls visit(BlockKey, crossed, ends) for every block with a mark and forgets the marks.
  template <class Visit>
  void take(Visit visit) {
    const auto is_key = [](int b) { return b >= 0 && b < BlockKey::kSide; };
    walk_waiting();
    merge_sparse();
    std::size_t word = 0;
    for (int z = corner_.z; z < corner_.z + sides_.z; ++z) {
      for (int y = corner_.y; y < corner_.y + sides_.y; ++y) {
        for (int x = corner_.x; x < corner_.x + sides_.x; ++x, word += BlockKey::kVoxels) {
          Marks marks;
          if (take_dense(word, marks) && is_key(x) && is_key(y) && is_key(z)) {
            visit(block_key(x, y, z), marks.crossed, marks.ends);
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

  static BlockKey block_key(int x, int y, int z) {
    return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
            static_cast<std::uint16_t>(z)};
  }
  static std::uint64_t packed(BlockKey key);
  static BlockKey unpacked(std::uint64_t packed);

  void lay_volume(const Box& dense);
  void walk_waiting();
  void mark_crossed_sparse(RayWalk::Cell cell);
  void merge_sparse();
  bool take_dense(std::size_t word, Marks& marks);

  Box dense_;      // voxels whose rays stay in the volume
  Blocks corner_;  // the volume's first block; -1 where rays may lead out of the octree
  Blocks sides_;
  std::vector<std::uint32_t> bit_of_x_, bit_of_y_, bit_of_z_;  // voxel of the volume -> bit
  std::vector<std::uint64_t> crossed_, ends_;                  // 8 words a block; 0 when idle
  std::vector<RayWalk> near_, far_;  // rays that wait to be walked in the volume, or across it
  std::unordered_map<std::uint64_t, Marks> sparse_;  // by packed BlockKey
};

}  // namespace portolan
