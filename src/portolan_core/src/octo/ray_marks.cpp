// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ray_marks.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace portolan {

namespace {

constexpr int kVoxels = BlockKey::kVoxels;
constexpr std::size_t kRaysAtOnce = 256;  // few enough to stay in the nearest cache

/// The block of a voxel; keys below 0 lie in block -1.
int block_of(int key) { return (key + kVoxels) / kVoxels - 1; }

int first_block(int min_key) { return block_of(min_key - RayWalk::kOvershoot); }
int count_of_blocks(int min_key, int max_key) {
  return block_of(max_key + RayWalk::kOvershoot) - first_block(min_key) + 1;
}

std::int64_t count_of_voxels(const RayMarks::Box& box) {
  std::int64_t voxels = kVoxels * kVoxels * kVoxels;
  for (int i = 0; i < 3; ++i) voxels *= count_of_blocks(box.min[i], box.max[i]);
  return voxels;
}

/// The part of the box within `reach` voxels of its centre.
RayMarks::Box clipped(const RayMarks::Box& box, const octomap::OcTreeKey& centre, int reach) {
  RayMarks::Box part;
  for (unsigned i = 0; i < 3; ++i) {
    const int middle = std::clamp<int>(centre[i], box.min[i], box.max[i]);
    part.min[i] = std::max(box.min[i], middle - reach);
    part.max[i] = std::min(box.max[i], middle + reach);
  }
  return part;
}

void set_bit(std::uint64_t* words, std::size_t bit) {
  words[bit >> 6] |= std::uint64_t{1} << (bit & 63);
}

void set_bit(VoxelMask& mask, std::size_t x, std::size_t y, std::size_t z) {
  mask[z % kVoxels] |= std::uint64_t{1} << (y % kVoxels * kVoxels + x % kVoxels);
}

/// Calls visit(x, y, z) for each voxel of a mask.
template <class Visit>
void for_each_voxel(const VoxelMask& mask, Visit visit) {
  for (std::size_t z = 0; z < mask.size(); ++z) {
    for (std::uint64_t bits = mask[z]; bits != 0; bits &= bits - 1) {
      const int i = __builtin_ctzll(bits);
      visit(i % kVoxels, i / kVoxels, static_cast<int>(z));
    }
  }
}

/// Eight bytes that are 0 or 1 as eight bits.
std::uint64_t gathered(std::uint64_t bytes) { return (bytes * 0x0102040810204080U) >> 56; }

/// The rows of a block, each a value of type Row, read and set to zero. False where all were zero.
template <class Row>
bool take_rows(Row* first, std::size_t row, std::size_t layer, std::array<Row, 64>& rows) {
  Row any = 0;
  for (std::size_t z = 0; z < 8; ++z) {
    for (std::size_t y = 0; y < 8; ++y) any |= rows[8 * z + y] = first[z * layer + y * row];
  }
  if (any == 0) return false;
  for (std::size_t z = 0; z < 8; ++z) {
    for (std::size_t y = 0; y < 8; ++y) first[z * layer + y * row] = 0;
  }
  return true;
}

}  // namespace

void RayMarks::start(const Box& box, const octomap::OcTreeKey& centre) {
  int reach = VoxelLattice::kSide;
  Box dense = clipped(box, centre, reach);
  while (count_of_voxels(dense) > limits_.max_voxels) {
    reach -= reach / 8;
    dense = clipped(box, centre, reach);
  }
  lay_volume(dense);
}

void RayMarks::mark_crossed(const RayStart& start, const octomap::point3d& end,
                            const octomap::OcTreeKey& key_end) {
  const bool is_near = start.key() && is_in_volume(*start.key()) && is_in_volume(key_end);
  const auto ray = start.walk_to(end, key_end, is_near ? axes_ : RayWalk::Axes());
  if (!ray) return;
  std::vector<RayWalk>& waiting = is_near ? near_ : far_;
  waiting.push_back(*ray);
  if (waiting.size() == kRaysAtOnce) walk_waiting();
}

void RayMarks::walk_waiting() {
  if (has_bytes_) {
    auto* bytes = reinterpret_cast<std::uint8_t*>(marks_.data());
    walk(near_, first_, [bytes](RayWalk::Cell place) { bytes[place] = 1; });
  } else {
    walk(near_, first_, [words = marks_.data()](RayWalk::Cell place) { set_bit(words, place); });
  }
  near_.clear();
  walk(far_, RayWalk::Axes().cell(-kVoxels, -kVoxels, -kVoxels),
       [this](RayWalk::Cell cell) { mark_crossed_sparse(cell); });
  far_.clear();
}

void RayMarks::mark_end(const octomap::OcTreeKey& key) {
  const BlockKey block = portolan::block_of(key);
  VoxelMask& ends =
      is_in_volume(key)
          ? ends_[index({block.x - corner_.x, block.y - corner_.y, block.z - corner_.z})]
          : sparse_[packed(block)].ends;
  set_bit(ends, key[0], key[1], key[2]);
}

std::uint64_t RayMarks::packed(BlockKey key) {
  return key.x | std::uint64_t{key.y} << 16 | std::uint64_t{key.z} << 32;
}

BlockKey RayMarks::unpacked(std::uint64_t packed) {
  return {static_cast<std::uint16_t>(packed), static_cast<std::uint16_t>(packed >> 16),
          static_cast<std::uint16_t>(packed >> 32)};
}

void RayMarks::lay_volume(const Box& dense) {
  dense_ = dense;
  corner_ = {first_block(dense.min[0]), first_block(dense.min[1]), first_block(dense.min[2])};
  sides_ = {count_of_blocks(dense.min[0], dense.max[0]),
            count_of_blocks(dense.min[1], dense.max[1]),
            count_of_blocks(dense.min[2], dense.max[2])};
  axes_.y = static_cast<RayWalk::Cell>(kVoxels) * static_cast<RayWalk::Cell>(sides_.x);
  axes_.z = axes_.y * static_cast<RayWalk::Cell>(kVoxels * sides_.y);
  first_ = axes_.cell(kVoxels * corner_.x, kVoxels * corner_.y, kVoxels * corner_.z);
  const std::int64_t voxels = count_of_voxels(dense);
  has_bytes_ = voxels <= limits_.byte_voxels;
  const auto words = static_cast<std::size_t>(voxels / (has_bytes_ ? 8 : 64));
  if (marks_.size() < words) marks_.resize(words);
  const auto blocks = static_cast<std::size_t>(voxels / (kVoxels * kVoxels * kVoxels));
  if (ends_.size() < blocks) ends_.resize(blocks);
}

void RayMarks::mark_crossed_sparse(RayWalk::Cell cell) {
  const auto is_key = [](std::size_t k) {
    return k >= kVoxels && k < VoxelLattice::kSide + kVoxels;
  };
  const std::size_t x = RayWalk::x(cell);
  const std::size_t y = RayWalk::y(cell);
  const std::size_t z = RayWalk::z(cell);
  if (!is_key(x) || !is_key(y) || !is_key(z)) return;
  const auto block = [](std::size_t k) { return static_cast<int>(k / kVoxels) - 1; };
  set_bit(sparse_[packed(block_key(block(x), block(y), block(z)))].crossed, x, y, z);
}

/// Moves what lies in the volume there, which far rays cross as well.
void RayMarks::merge_sparse() {
  auto* bytes = reinterpret_cast<std::uint8_t*>(marks_.data());
  for (auto entry = sparse_.begin(); entry != sparse_.end();) {
    const BlockKey key = unpacked(entry->first);
    const Blocks at{key.x - corner_.x, key.y - corner_.y, key.z - corner_.z};
    const bool inside = at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < sides_.x && at.y < sides_.y &&
                        at.z < sides_.z;
    if (!inside) {
      ++entry;
      continue;
    }
    for_each_voxel(entry->second.crossed, [&](int x, int y, int z) {
      const RayWalk::Cell place = first_of(at) + axes_.cell(x, y, z);
      if (has_bytes_) {
        bytes[place] = 1;
      } else {
        set_bit(marks_.data(), place);
      }
    });
    VoxelMask& ends = ends_[index(at)];
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] |= entry->second.ends[i];
    entry = sparse_.erase(entry);
  }
}

/// Reads the marks of a block and forgets them; false where there are none.
bool RayMarks::take_block(const Blocks& at, Marks& marks) {
  marks.ends = std::exchange(ends_[index(at)], {});
  std::uint64_t any = 0;
  for (const std::uint64_t word : marks.ends) any |= word;
  const RayWalk::Cell first = first_of(at);
  if (has_bytes_) {
    std::array<std::uint64_t, 64> rows;
    if (!take_rows(marks_.data() + first / 8, axes_.y / 8, axes_.z / 8, rows)) return any != 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      marks.crossed[i / 8] |= gathered(rows[i]) << (i % 8 * 8);
    }
  } else {
    std::array<std::uint8_t, 64> rows;
    auto* bytes = reinterpret_cast<std::uint8_t*>(marks_.data());
    if (!take_rows(bytes + first / 8, axes_.y / 8, axes_.z / 8, rows)) return any != 0;
    std::memcpy(marks.crossed.data(), rows.data(), sizeof(rows));
  }
  return true;
}

}  // namespace portolan
