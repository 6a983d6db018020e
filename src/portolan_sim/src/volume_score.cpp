// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/volume_score.hpp"

#include <optional>

namespace portolan::sim {

namespace {

void ask(CellShare& share, bool good) {
  ++share.of;
  if (good) ++share.good;
}

std::optional<bool> is_occupied(const OctoMapper& map, const Eigen::Vector3d& p_map) {
  const Eigen::Vector3f p = p_map.cast<float>();
  const std::optional<float> log_odds = map.log_odds({p.x(), p.y(), p.z()});
  if (!log_odds) return std::nullopt;
  return *log_odds >= map.threshold_log_odds();
}

/// Whether the voxel or one that touches it is occupied.
bool is_occupied_nearby(const OctoMapper& map, const Eigen::Vector3d& centre) {
  const double side = map.lattice().resolution();
  for (int i = 0; i < 27; ++i) {
    const Eigen::Vector3i step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (is_occupied(map, centre + side * step.cast<double>()).value_or(false)) return true;
  }
  return false;
}

/// What the map says, against the world.
void score_voxels(const OctoMapper& map, const World& world, VolumeScore& score) {
  const VoxelLattice& lattice = map.lattice();
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    for (int i = 0; i < 512; ++i) {
      if (!block.is_known(static_cast<std::size_t>(i))) continue;
      const Eigen::Vector3d centre(lattice.centre(8 * key.x + i % 8),
                                   lattice.centre(8 * key.y + i / 8 % 8),
                                   lattice.centre(8 * key.z + i / 64));
      if (block.log_odds[static_cast<std::size_t>(i)] >= map.threshold_log_odds()) {
        ask(score.occupied_precision, world.reaches_into(centre, 1.5 * lattice.resolution()));
      } else {
        ask(score.free_precision, !world.is_solid(centre));
      }
    }
  });
}

/// What could be seen, against the map.
void score_view(const OctoMapper& map, const World& world, const VolumeView& view,
                VolumeScore& score) {
  const double half = 0.5 * map.lattice().resolution();
  view.for_each_seen([&](const Eigen::Vector3d& centre, VolumeView::Voxel voxel) {
    if (voxel == VolumeView::Voxel::surface) {
      ask(score.occupied_recall, is_occupied_nearby(map, centre));
    } else if (!world.reaches_into(centre, half)) {
      ask(score.free_recall, !is_occupied(map, centre).value_or(true));
    }
  });
}

}  // namespace

VolumeScore score(const OctoMapper& map, const World& world, const VolumeView& view) {
  VolumeScore score;
  score_voxels(map, world, score);
  score_view(map, world, view, score);
  return score;
}

}  // namespace portolan::sim
