// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/projection.hpp"

#include <algorithm>
#include <set>

namespace portolan {

namespace {

constexpr int kVoxels = BlockKey::kVoxels;

std::int8_t cell_value(bool known, bool occupied) {
  if (occupied) return 100;
  return known ? 0 : -1;
}

}  // namespace

void Projection::follow(const OctoMapper& map, std::size_t generation) {
  if (seen_ && generation != generation_) *this = Projection(shown_);
  lattice_ = map.lattice();
  std::set<Place> changed;
  const auto note = [&](BlockKey key, const VoxelBlock& /*block*/) {
    for_each_affected(key, shown_, [&](BlockKey at) { changed.emplace(at.x, at.y); });
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
    const BlockKey key = block_key(place.first, place.second, z);
    const VoxelMask band = in_band(map, key, shown_.band);
    if (std::all_of(band.begin(), band.end(), [](auto layer) { return layer == 0; })) continue;
    const VoxelBlock* block = map.blocks().find(key);
    if (block == nullptr) continue;
    const VoxelMask mask = shown_voxels(map, key, *block, shown_);
    for (std::size_t layer = 0; layer < mask.size(); ++layer) {
      columns.known |= block->known[layer] & band[layer];
      columns.occupied |= mask[layer];
    }
  }
  return columns;
}

Projection::Bounds Projection::bounds() const {
  Bounds bounds;
  for (const auto& [place, columns] : columns_) {
    bounds.low_y = std::min(bounds.low_y, place.second);
    bounds.high_y = std::max(bounds.high_y, place.second);
  }
  if (columns_.empty()) return bounds;
  bounds.low_x = columns_.begin()->first.first;
  bounds.high_x = columns_.rbegin()->first.first;
  return bounds;
}

double Projection::area() const {
  if (columns_.empty()) return 0.0;
  const Bounds bounds = this->bounds();
  return 64.0 * (bounds.high_x - bounds.low_x + 1) * (bounds.high_y - bounds.low_y + 1);
}

Projection::Grid Projection::grid() const {
  Grid grid;
  if (columns_.empty()) return grid;
  const auto [low_x, low_y, high_x, high_y] = bounds();
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
