// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/cell_markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace portolan {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr int kBlocks = 8;                          // of a brick, along each axis
constexpr int kBricks = BlockKey::kSide / kBlocks;  // of the octree, likewise

std::int32_t brick_id(BlockKey key) {
  return (key.z / kBlocks * kBricks + key.y / kBlocks) * kBricks + key.x / kBlocks;
}

/// The block in the lowest corner of a brick.
std::array<int, 3> first_block(std::int32_t id) {
  return {id % kBricks * kBlocks, id / kBricks % kBricks * kBlocks,
          id / kBricks / kBricks * kBlocks};
}

Marker empty_marker(std::int32_t id) {
  Marker marker;
  marker.ns = "map";
  marker.id = id;
  marker.type = Marker::CUBE_LIST;
  marker.action = Marker::DELETE;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker delete_all() {
  Marker marker;
  marker.action = Marker::DELETEALL;
  marker.pose.orientation.w = 1.0;
  return marker;
}

/// The colour at a turn of the wheel: 0 and 1 are red, between them green and blue.
std_msgs::ColorRGBA hue(double turn) {
  const auto part = [turn](double peak) {
    const double away = std::abs(std::remainder(turn - peak, 1.0));
    return static_cast<float>(std::clamp(2.0 - 6.0 * away, 0.1, 0.95));
  };
  std_msgs::ColorRGBA colour;
  colour.r = part(0.0);
  colour.g = part(1.0 / 3.0);
  colour.b = part(2.0 / 3.0);
  colour.a = 1.0F;
  return colour;
}

void add_cubes(const VoxelLattice& lattice, BlockKey key, const VoxelMask& mask, Marker& marker) {
  for (int z = 0; z < BlockKey::kVoxels; ++z) {
    for (int i = 0; i < 64; ++i) {
      if (((mask[static_cast<std::size_t>(z)] >> i) & 1) == 0) continue;
      geometry_msgs::Point p;
      p.x = lattice.centre(BlockKey::kVoxels * key.x + i % 8);
      p.y = lattice.centre(BlockKey::kVoxels * key.y + i / 8);
      p.z = lattice.centre(BlockKey::kVoxels * key.z + z);
      marker.points.push_back(p);
    }
  }
}

}  // namespace

MarkerArray CellMarkers::changes(const OctoMapper& map, std::size_t generation) {
  MarkerArray markers;
  if (!seen_ || generation != generation_) {
    seen_.reset();
    sent_.clear();
    markers.markers.push_back(delete_all());
  }
  for (const BrickId id : changed_bricks(map)) {
    Marker marker = brick(map, id);
    const bool was_sent = sent_.count(id) > 0;
    if (!marker.points.empty()) {
      sent_.insert(id);
    } else if (was_sent) {
      sent_.erase(id);
    } else {
      continue;
    }
    markers.markers.push_back(std::move(marker));
  }
  seen_ = map.revision();
  generation_ = generation;
  return markers;
}

std::set<CellMarkers::BrickId> CellMarkers::changed_bricks(const OctoMapper& map) const {
  std::set<BrickId> bricks;
  const auto note = [&](BlockKey key, const VoxelBlock& /*block*/) {
    for_each_affected(key, shown_, [&](BlockKey at) { bricks.insert(brick_id(at)); });
  };
  if (seen_) {
    map.blocks().for_each_changed_since(*seen_, note);
  } else {
    map.blocks().for_each(note);
  }
  return bricks;
}

Marker CellMarkers::brick(const OctoMapper& map, BrickId id) const {
  Marker marker = empty_marker(id);
  const auto [x_0, y_0, z_0] = first_block(id);
  for (int i = 0; i < kBlocks * kBlocks * kBlocks; ++i) {
    const BlockKey key =
        block_key(x_0 + i % kBlocks, y_0 + i / kBlocks % kBlocks, z_0 + i / kBlocks / kBlocks);
    const VoxelBlock* block = map.blocks().find(key);
    if (block == nullptr) continue;
    add_cubes(map.lattice(), key, shown_voxels(map, key, *block, shown_), marker);
  }
  if (marker.points.empty()) return marker;
  marker.action = Marker::ADD;
  marker.scale.x = marker.scale.y = marker.scale.z = map.lattice().resolution();
  marker.color.a = 1.0F;
  for (const geometry_msgs::Point& p : marker.points) {
    marker.colors.push_back(hue(p.z / colour_period_));
  }
  return marker;
}

}  // namespace portolan
