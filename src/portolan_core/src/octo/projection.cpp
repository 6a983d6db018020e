// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/projection.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace portolan {

namespace {

constexpr int kVoxels = BlockKey::kVoxels;

BlockKey block_key(int x, int y, int z) {
  return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
          static_cast<std::uint16_t>(z)};
}

std::int8_t cell_value(bool known, bool occupied) {
  if (occupied) return 100;
  return known ? 0 : -1;
}

}  // namespace

void Projection::follow(const OctoMapper& map, std::size_t generation) {
  if (seen_ && generation != generation_) *this = Projection(band_);
  lattice_ = map.lattice();
  std::set<Place> changed;
  const auto note = [&](BlockKey key, const VoxelBlock& /*block*/) {
    changed.emplace(key.x, key.y);
    lowest_ = std::min<int>(lowest_, key.z);
    highest_ = std::max<int>(highest_, key.z);
  };
  if (seen_) {
    map.blocks().for_each_changed_since(*seen_, note);
  } else {
    map.blocks().for_each(note);
  }
  for (const Place& place : changed) {
    const Columns columns = look_down(map, place);
    if (columns.known != 0) columns_[place] = columns;
  }
  seen_ = map.revision();
  generation_ = generation;
}

Projection::Columns Projection::look_down(const OctoMapper& map, const Place& place) const {
  Columns columns;
  for (int z = lowest_; z <= highest_; ++z) {
    const bool reaches_band = band_.contains(*lattice_, kVoxels * z) ||
                              band_.contains(*lattice_, kVoxels * z + kVoxels - 1) ||
                              (lattice_->centre(kVoxels * z) < band_.min_z &&
                               lattice_->centre(kVoxels * z + kVoxels - 1) > band_.max_z);
    if (!reaches_band) continue;
    const VoxelBlock* block = map.blocks().find(block_key(place.first, place.second, z));
    if (block == nullptr) continue;
    const VoxelMask mask = occupied(*block, map.threshold_log_odds());
    for (int layer = 0; layer < kVoxels; ++layer) {
      if (!band_.contains(*lattice_, kVoxels * z + layer)) continue;
      columns.known |= block->known[static_cast<std::size_t>(layer)];
      columns.occupied |= mask[static_cast<std::size_t>(layer)];
    }
  }
  return columns;
}

Projection::Grid Projection::grid() const {
  Grid grid;
  if (columns_.empty()) return grid;
  int low_y = std::numeric_limits<int>::max();
  int high_y = -1;
  for (const auto& [place, columns] : columns_) {
    low_y = std::min(low_y, place.second);
    high_y = std::max(high_y, place.second);
  }
  const int low_x = columns_.begin()->first.first;
  const int high_x = columns_.rbegin()->first.first;
  const double half = 0.5 * lattice_->resolution();
  grid.resolution = lattice_->resolution();
  grid.x = lattice_->centre(kVoxels * low_x) - half;
  grid.y = lattice_->centre(kVoxels * low_y) - half;
  const int width = kVoxels * (high_x - low_x + 1);
  const int height = kVoxels * (high_y - low_y + 1);
  grid.width = static_cast<std::size_t>(width);
  grid.height = static_cast<std::size_t>(height);
  grid.cells.assign(grid.width * grid.height, -1);
  for (const auto& [place, columns] : columns_) {
    const int corner_x = kVoxels * (place.first - low_x);
    const int corner_y = kVoxels * (place.second - low_y);
    const auto x = static_cast<std::size_t>(corner_x);
    const auto y = static_cast<std::size_t>(corner_y);
    for (std::size_t i = 0; i < 64; ++i) {
      grid.cells[(y + i / 8) * grid.width + x + i % 8] =
          cell_value((columns.known >> i & 1) != 0, (columns.occupied >> i & 1) != 0);
    }
  }
  return grid;
}

}  // namespace portolan
