// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "portolan/octo/voxel_block.hpp"

namespace portolan {

/// All blocks of a map that hold something, found by key, and remembered in the order in which
/// they changed, so that whoever follows the map looks only at what is new to him.
class VoxelBlocks {
 public:
  using Revision = std::uint64_t;

  VoxelBlocks();

  std::size_t size() const { return blocks_.size(); }

  /// The block with this key; nullptr where nothing is known.
  const VoxelBlock* find(BlockKey key) const;

  /// The block with this key, made if there is none, to be changed in `revision`. Revisions do not
  /// decrease.
  VoxelBlock& change(BlockKey key, Revision revision);

  /// Calls visit(key, block) for every block that changed after `revision`, the last one first.
  template <class Visit>
  void for_each_changed_since(Revision revision, Visit visit) const {
    for (std::uint32_t i = newest_; i != kNone && entries_[i].revision > revision;
         i = entries_[i].older) {
      visit(entries_[i].key, blocks_[i]);
    }
  }

  /// Calls visit(key, block) for every block, in the order in which they were made.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < blocks_.size(); ++i) visit(entries_[i].key, blocks_[i]);
  }

  /// The revision of the last change; 0 where there is no block.
  Revision newest_revision() const { return newest_ == kNone ? 0 : entries_[newest_].revision; }

  /// What they occupy in memory [byte].
  std::size_t byte_size() const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Entry {
    BlockKey key;
    std::uint32_t newer = kNone;
    std::uint32_t older = kNone;
    Revision revision = 0;
  };

  std::size_t slot_of(BlockKey key) const;
  std::uint32_t make(std::size_t slot, BlockKey key);
  void grow_table();
  void unlink(std::uint32_t i);
  void link_as_newest(std::uint32_t i);

  std::vector<std::uint32_t> table_;  // open addressing; its size is a power of two
  std::vector<Entry> entries_;
  std::deque<VoxelBlock> blocks_;
  std::uint32_t newest_ = kNone;
};

}  // namespace portolan
