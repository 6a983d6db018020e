// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octo_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace portolan {

namespace {

constexpr std::size_t kVoxels = BlockKey::kVoxels;

using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

/// `value` where the bit is set, else 0.
Floats masked(float value, Ints bits, std::int32_t mask) {
  const Ints is_set = (bits & mask) == bits;
  Floats all = Floats{} + value;
  Ints kept;
  std::memcpy(&kept, &all, sizeof(kept));
  kept &= is_set;
  std::memcpy(&all, &kept, sizeof(all));
  return all;
}

/// Four neighbouring voxels at once, of these bits: log-odds add up and are clamped; what already
/// lies beyond the bound that it moves towards stays, as in octomap::OcTree::updateNode.
void update_four(float* voxels, Ints bits, std::int32_t hits, std::int32_t misses,
                 const LogOddsModel& model) {
  const Floats max = Floats{} + model.max;
  const Floats min = Floats{} + model.min;
  const Floats update = masked(model.hit, bits, hits) + masked(model.miss, bits, misses);
  Floats old;
  std::memcpy(&old, voxels, sizeof(old));
  const Floats sum = old + update;
  const Floats old_above = max < old ? old : max;
  const Floats old_below = old < min ? old : min;
  const Floats high = update >= 0.0F ? old_above : max;
  const Floats low = update <= 0.0F ? old_below : min;
  const Floats raised = sum < low ? low : sum;
  const Floats clamped = high < raised ? high : raised;
  std::memcpy(voxels, &clamped, sizeof(clamped));
}

void update_row(float* row, std::int32_t hits, std::int32_t misses, const LogOddsModel& model) {
  update_four(row, Ints{1, 2, 4, 8}, hits, misses, model);
  update_four(row + 4, Ints{16, 32, 64, 128}, hits, misses, model);
}

void update(VoxelBlock& block, const VoxelMask& crossed, const VoxelMask& ends,
            const LogOddsModel& model) {
  for (std::size_t z = 0; z < kVoxels; ++z) {
    const std::uint64_t hits = ends[z];
    const std::uint64_t misses = crossed[z] & ~hits;
    if ((hits | misses) == 0) continue;
    block.known[z] |= hits | misses;
    for (std::size_t y = 0; y < kVoxels; ++y) {
      const auto row_hits = static_cast<std::int32_t>(hits >> (8 * y) & 0xff);
      const auto row_misses = static_cast<std::int32_t>(misses >> (8 * y) & 0xff);
      if ((row_hits | row_misses) == 0) continue;
      update_row(&block.log_odds[64 * z + 8 * y], row_hits, row_misses, model);
    }
  }
}

/// Calls visit(start, ray) for each ray of a sweep.
template <class Visit>
void for_each_ray(const Sweep& sweep, const VoxelLattice& lattice, Visit visit) {
  std::optional<RayStart> start;
  for (const Sweep::Ray& ray : sweep.rays()) {
    if (!start || !(start->origin() == ray.origin)) start.emplace(lattice, ray.origin);
    visit(*start, ray);
  }
}

/// The box around the corners of a posed box.
Eigen::AlignedBox3d bounds(const ClearBox& box, const Pose& T_map_box) {
  Eigen::AlignedBox3d all;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
    all.extend(T_map_box * box.box.corner(corner));
  }
  return all;
}

/// Whether any part of the block lies in the box around.
bool meets(BlockKey key, const VoxelLattice& lattice, const Eigen::AlignedBox3d& around) {
  const auto corner = [&](int add) {
    return Eigen::Vector3d(lattice.centre(8 * key.x + add), lattice.centre(8 * key.y + add),
                           lattice.centre(8 * key.z + add));
  };
  return around.intersects(Eigen::AlignedBox3d(corner(0), corner(7)));
}

/// The known voxels of a block with their centre in the box.
VoxelMask within(const ClearBox& box, const Pose& T_box_map, const VoxelLattice& lattice,
                 BlockKey key, const VoxelBlock& block) {
  VoxelMask mask{};
  for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
    if (!block.is_known(i)) continue;
    const auto place = static_cast<int>(i);
    const Eigen::Vector3d centre(lattice.centre(8 * key.x + place % 8),
                                 lattice.centre(8 * key.y + place / 8 % 8),
                                 lattice.centre(8 * key.z + place / 64));
    if (box.box.contains(T_box_map * centre)) mask[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  return mask;
}

bool is_usable(const ClearBox& box) {
  return box.box.min().allFinite() && box.box.max().allFinite() && !box.box.isEmpty();
}

void add(PointCounts& sum, const PointCounts& more) {
  sum.hits += more.hits;
  sum.beyond_range += more.beyond_range;
  sum.ground += more.ground;
  sum.no_returns += more.no_returns;
  sum.too_near += more.too_near;
  sum.not_finite += more.not_finite;
  sum.outside_octree += more.outside_octree;
  sum.silent += more.silent;
}

}  // namespace

OctoMapper::OctoMapper(const Options& options)
    : options_(checked(options)), lattice_(options_.resolution), model_(options_.sensor_model) {}

OctoMapper::OctoMapper(const Options& options, VoxelBlocks blocks) : OctoMapper(options) {
  blocks_ = std::move(blocks);
  revision_ = blocks_.newest_revision();
}

Outcome OctoMapper::insert(const Observation& z, const Pose& T_map_sensor) {
  if (!is_valid(T_map_sensor)) return Outcome::rejected;
  return std::visit([&](const auto& seen) { return draw(seen, T_map_sensor); }, z);
}

std::optional<float> OctoMapper::log_odds(const octomap::point3d& p_map) const {
  const auto key = lattice_.key(p_map);
  if (!key) return std::nullopt;
  const VoxelBlock* block = blocks_.find(block_of(*key));
  const std::size_t i = VoxelBlock::index((*key)[0] % 8, (*key)[1] % 8, (*key)[2] % 8);
  if (block == nullptr || !block->is_known(i)) return std::nullopt;
  return block->log_odds[i];
}

std::optional<Eigen::AlignedBox3d> OctoMapper::changed_since(Revision revision) const {
  Eigen::AlignedBox3d box;
  blocks_.for_each_changed_since(revision, [&](BlockKey key, const VoxelBlock& /*block*/) {
    const Eigen::Array3d centre(lattice_.centre(8 * key.x), lattice_.centre(8 * key.y),
                                lattice_.centre(8 * key.z));
    const Eigen::Array3d low = centre - 0.5 * lattice_.resolution();
    box.extend(low.matrix());
    box.extend((low + 8.0 * lattice_.resolution()).matrix());
  });
  if (box.isEmpty()) return std::nullopt;
  return box;
}

Outcome OctoMapper::draw(const RangeScan& scan, const Pose& T_map_sensor) {
  if (!is_usable(scan)) return Outcome::unusable;
  Sweep sweep(lattice_, options_.sensor_model, options_.no_return, false);
  sweep.add(scan, T_map_sensor);
  draw(sweep);
  return Outcome::inserted;
}

template <class Cloud>
Outcome OctoMapper::draw(const Cloud& cloud, const Pose& T_map_sensor) {
  Sweep sweep(lattice_, options_.sensor_model, options_.no_return, options_.discretize);
  sweep.add(cloud, T_map_sensor);
  draw(sweep);
  return Outcome::inserted;
}

void OctoMapper::draw(const Sweep& sweep) {
  ++revision_;
  add(counts_, sweep.counts());
  RayMarks::Box box;
  std::optional<octomap::OcTreeKey> centre;
  for_each_ray(sweep, lattice_, [&](const RayStart& start, const Sweep::Ray& ray) {
    if (ray.key) box.extend(*ray.key);
    if (start.key()) box.extend(*start.key());
    centre = start.key() ? start.key() : ray.key ? ray.key : centre;
  });
  if (!centre) return;
  marks_.start(box, *centre);
  for_each_ray(sweep, lattice_, [&](const RayStart& start, const Sweep::Ray& ray) {
    if (!ray.key) return;
    marks_.mark_crossed(start, ray.end, *ray.key);
    if (ray.hit) marks_.mark_end(*ray.key);
  });
  marks_.take([this](BlockKey key, const VoxelMask& crossed, const VoxelMask& ends) {
    update(blocks_.change(key, revision_), crossed, ends, model_);
  });
}

Outcome OctoMapper::draw(const ClearBox& box, const Pose& T_map_box) {
  if (!is_usable(box)) return Outcome::unusable;
  ++revision_;
  const Eigen::AlignedBox3d around = bounds(box, T_map_box);
  const Pose T_box_map = T_map_box.inverse();
  std::vector<std::pair<BlockKey, VoxelMask>> cleared;
  blocks_.for_each([&](BlockKey key, const VoxelBlock& block) {
    if (meets(key, lattice_, around)) {
      cleared.emplace_back(key, within(box, T_box_map, lattice_, key, block));
    }
  });
  for (const auto& [key, mask] : cleared) {
    VoxelBlock& block = blocks_.change(key, revision_);
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
      if (((mask[i / 64] >> (i % 64)) & 1) != 0) block.log_odds[i] = model_.min;
    }
  }
  return Outcome::inserted;
}

}  // namespace portolan
