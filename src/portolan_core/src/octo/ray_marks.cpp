// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ray_marks.hpp"

#include <algorithm>
#include <utility>

namespace portolan {

namespace {

constexpr int kVoxels = BlockKey::kVoxels;
constexpr std::size_t kRaysAtOnce = 256;  // few enough to stay in the nearest cache
constexpr std::int64_t kMaxDenseBits = std::int64_t{1} << 30;

/// The block of a voxel; keys below 0 lie in block -1.
int block_of(int key) { return (key + kVoxels) / kVoxels - 1; }

int first_block(int min_key) { return block_of(min_key - RayWalk::kOvershoot); }
int count_of_blocks(int min_key, int max_key) {
  return block_of(max_key + RayWalk::kOvershoot) - first_block(min_key) + 1;
}

std::int64_t count_of_bits(const RayMarks::Box& box) {
  std::int64_t bits = 512;
  for (int i = 0; i < 3; ++i) bits *= count_of_blocks(box.min[i], box.max[i]);
  return bits;
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

/// Table from a voxel's place on one axis of the volume to its share of the bit's address.
void fill_bits(std::vector<std::uint32_t>& bits, int blocks, std::int64_t block_stride,
               std::int64_t voxel_stride) {
  bits.resize(static_cast<std::size_t>(blocks) * kVoxels);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const auto place = static_cast<std::int64_t>(i);
    bits[i] = static_cast<std::uint32_t>(place / kVoxels * block_stride * 512 +
                                         place % kVoxels * voxel_stride);
  }
}

void set_bit(std::uint64_t* words, std::size_t bit) {
  words[bit >> 6] |= std::uint64_t{1} << (bit & 63);
}

void set_bit(VoxelMask& mask, std::size_t x, std::size_t y, std::size_t z) {
  mask[z % kVoxels] |= std::uint64_t{1} << (y % kVoxels * kVoxels + x % kVoxels);
}

}  // namespace

void RayMarks::Box::extend(const octomap::OcTreeKey& key) {
  for (unsigned i = 0; i < 3; ++i) {
    min[i] = std::min<int>(min[i], key[i]);
    max[i] = std::max<int>(max[i], key[i]);
  }
}

bool RayMarks::Box::contains(int x, int y, int z) const {
  return x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1] && z >= min[2] && z <= max[2];
}

void RayMarks::start(const Box& box, const octomap::OcTreeKey& centre) {
  int reach = VoxelLattice::kSide;
  Box dense = clipped(box, centre, reach);
  while (count_of_bits(dense) > kMaxDenseBits) {
    reach -= reach / 8;
    dense = clipped(box, centre, reach);
  }
  lay_volume(dense);
}

void RayMarks::mark_crossed(const RayWalk& ray) {
  const auto stays = [this](RayWalk::Cell cell) {
    return dense_.contains(static_cast<int>(RayWalk::x(cell)), static_cast<int>(RayWalk::y(cell)),
                           static_cast<int>(RayWalk::z(cell)));
  };
  std::vector<RayWalk>& waiting = stays(ray.start) && stays(ray.end) ? near_ : far_;
  waiting.push_back(ray);
  if (waiting.size() == kRaysAtOnce) walk_waiting();
}

void RayMarks::walk_waiting() {
  const std::uint32_t* x = bit_of_x_.data();
  const std::uint32_t* y = bit_of_y_.data();
  const std::uint32_t* z = bit_of_z_.data();
  walk(near_, RayWalk::cell(kVoxels * corner_.x, kVoxels * corner_.y, kVoxels * corner_.z),
       [x, y, z, words = crossed_.data()](RayWalk::Cell cell) {
         set_bit(words, x[RayWalk::x(cell)] + y[RayWalk::y(cell)] + z[RayWalk::z(cell)]);
       });
  near_.clear();
  walk(far_, RayWalk::cell(-kVoxels, -kVoxels, -kVoxels),
       [this](RayWalk::Cell cell) { mark_crossed_sparse(cell); });
  far_.clear();
}

void RayMarks::mark_end(const octomap::OcTreeKey& key) {
  if (!dense_.contains(key[0], key[1], key[2])) {
    const BlockKey block = block_key(key[0] / kVoxels, key[1] / kVoxels, key[2] / kVoxels);
    return set_bit(sparse_[packed(block)].ends, key[0], key[1], key[2]);
  }
  const auto place = [](int k, int corner) {
    return static_cast<std::size_t>(k - kVoxels * corner);
  };
  set_bit(ends_.data(), bit_of_x_[place(key[0], corner_.x)] + bit_of_y_[place(key[1], corner_.y)] +
                            bit_of_z_[place(key[2], corner_.z)]);
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
  fill_bits(bit_of_x_, sides_.x, 1, 1);
  fill_bits(bit_of_y_, sides_.y, sides_.x, kVoxels);
  fill_bits(bit_of_z_, sides_.z, std::int64_t{sides_.x} * sides_.y, kVoxels * kVoxels);
  const auto words = static_cast<std::size_t>(count_of_bits(dense) / 64);
  if (crossed_.size() < words) {
    crossed_.resize(words);
    ends_.resize(words);
  }
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

void RayMarks::merge_sparse() {
  for (auto entry = sparse_.begin(); entry != sparse_.end();) {
    const BlockKey key = unpacked(entry->first);
    const Blocks at{key.x - corner_.x, key.y - corner_.y, key.z - corner_.z};
    const bool inside = at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < sides_.x && at.y < sides_.y &&
                        at.z < sides_.z;
    if (!inside) {
      ++entry;
      continue;
    }
    const auto word = static_cast<std::size_t>(
        kVoxels * (at.x + std::int64_t{sides_.x} * (at.y + std::int64_t{sides_.y} * at.z)));
    for (std::size_t i = 0; i < kVoxels; ++i) {
      crossed_[word + i] |= entry->second.crossed[i];
      ends_[word + i] |= entry->second.ends[i];
    }
    entry = sparse_.erase(entry);
  }
}

bool RayMarks::take_dense(std::size_t word, Marks& marks) {
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < kVoxels; ++i) any |= crossed_[word + i] | ends_[word + i];
  if (any == 0) return false;
  for (std::size_t i = 0; i < kVoxels; ++i) {
    marks.crossed[i] = std::exchange(crossed_[word + i], 0);
    marks.ends[i] = std::exchange(ends_[word + i], 0);
  }
  return true;
}

}  // namespace portolan
