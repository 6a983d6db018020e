// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/voxel_blocks.hpp"

namespace portolan {

namespace {

std::uint64_t hash(BlockKey key) {
  const std::uint64_t packed = key.x | std::uint64_t{key.y} << 16 | std::uint64_t{key.z} << 32;
  return (packed * 0x9e3779b97f4a7c15u) >> 24;
}

}  // namespace

VoxelMask occupied(const VoxelBlock& block, float threshold_log_odds) {
  VoxelMask mask{};
  for (std::size_t z = 0; z < mask.size(); ++z) {
    if (block.known[z] == 0) continue;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      word |= std::uint64_t{block.log_odds[64 * z + i] >= threshold_log_odds} << i;
    }
    mask[z] = word & block.known[z];
  }
  return mask;
}

VoxelBlocks::VoxelBlocks() : table_(64, kNone) {}

const VoxelBlock* VoxelBlocks::find(BlockKey key) const {
  const std::uint32_t i = table_[slot_of(key)];
  return i == kNone ? nullptr : &blocks_[i];
}

VoxelBlock& VoxelBlocks::change(BlockKey key, Revision revision) {
  const std::size_t slot = slot_of(key);
  std::uint32_t i = table_[slot];
  if (i == kNone) {
    i = make(slot, key);
  } else if (entries_[i].revision != revision) {
    unlink(i);
    link_as_newest(i);
  }
  entries_[i].revision = revision;
  return blocks_[i];
}

std::size_t VoxelBlocks::byte_size() const {
  return blocks_.size() * sizeof(VoxelBlock) + entries_.capacity() * sizeof(Entry) +
         table_.capacity() * sizeof(std::uint32_t);
}

std::size_t VoxelBlocks::slot_of(BlockKey key) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(key) & mask;
  while (table_[slot] != kNone && !(entries_[table_[slot]].key == key)) slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t VoxelBlocks::make(std::size_t slot, BlockKey key) {
  const auto i = static_cast<std::uint32_t>(blocks_.size());
  blocks_.emplace_back();
  entries_.push_back({key, kNone, kNone, 0});
  table_[slot] = i;
  link_as_newest(i);
  if (2 * blocks_.size() > table_.size()) grow_table();
  return i;
}

void VoxelBlocks::grow_table() {
  table_.assign(2 * table_.size(), kNone);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) table_[slot_of(entries_[i].key)] = i;
}

void VoxelBlocks::unlink(std::uint32_t i) {
  const Entry& entry = entries_[i];
  if (entry.newer != kNone) entries_[entry.newer].older = entry.older;
  if (entry.older != kNone) entries_[entry.older].newer = entry.newer;
  if (newest_ == i) newest_ = entry.older;
}

void VoxelBlocks::link_as_newest(std::uint32_t i) {
  entries_[i].newer = kNone;
  entries_[i].older = newest_;
  if (newest_ != kNone) entries_[newest_].newer = i;
  newest_ = i;
}

}  // namespace portolan
