// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octree_mirror.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

namespace portolan {

namespace {

using octomap::OcTree;
using octomap::OcTreeNode;

constexpr int kBlockLevel = 3;  // levels of the octree within a block
constexpr int kTreeDepth = 16;

/// A block that changed, with its place along the Z-curve: three bits a level, the root's first.
struct Change {
  std::uint64_t place;
  BlockKey key;
  const VoxelBlock* block;
};
using Changes = std::vector<Change>::const_iterator;

std::uint64_t place_of(BlockKey key) {
  std::uint64_t place = 0;
  for (int bit = kTreeDepth - kBlockLevel - 1; bit >= 0; --bit) {
    const int child = (key.x >> bit & 1) | (key.y >> bit & 1) << 1 | (key.z >> bit & 1) << 2;
    place = place << 3 | static_cast<std::uint64_t>(child);
  }
  return place;
}

/// A cube of voxels within a block.
struct Cube {
  int x, y, z;
  int level;

  int side() const { return 1 << level; }
  std::size_t first() const { return VoxelBlock::index(x, y, z); }
  Cube child(unsigned i) const {
    const int half = side() / 2;
    return {x + ((i & 1) != 0 ? half : 0), y + ((i & 2) != 0 ? half : 0),
            z + ((i & 4) != 0 ? half : 0), level - 1};
  }
};

/// The cube's voxels within a layer's mask.
std::uint64_t bits_of_layer(const Cube& cube) {
  const std::uint64_t row = ((std::uint64_t{1} << cube.side()) - 1) << cube.x;
  std::uint64_t bits = 0;
  for (int y = cube.y; y < cube.y + cube.side(); ++y) bits |= row << (8 * y);
  return bits;
}

bool is_known_somewhere(const VoxelBlock& block, const Cube& cube) {
  const auto* layer = &block.known[static_cast<std::size_t>(cube.z)];
  const std::uint64_t bits = bits_of_layer(cube);
  return std::any_of(layer, layer + cube.side(), [bits](auto word) { return (word & bits) != 0; });
}

bool is_known_everywhere(const VoxelBlock& block, const Cube& cube) {
  const auto* layer = &block.known[static_cast<std::size_t>(cube.z)];
  const std::uint64_t bits = bits_of_layer(cube);
  return std::all_of(layer, layer + cube.side(),
                     [bits](auto word) { return (word & bits) == bits; });
}

/// Whether one leaf can stand for the whole cube.
bool holds_one_value(const VoxelBlock& block, const Cube& cube) {
  if (!is_known_everywhere(block, cube)) return false;
  const float value = block.log_odds[cube.first()];
  const auto differs = [value](float other) { return other != value; };
  for (int z = cube.z; z < cube.z + cube.side(); ++z) {
    for (int y = cube.y; y < cube.y + cube.side(); ++y) {
      const float* row = &block.log_odds[VoxelBlock::index(cube.x, y, z)];
      if (std::any_of(row, row + cube.side(), differs)) return false;
    }
  }
  return true;
}

/// A node of the tree, and whether it was only just made. One without children that was there
/// before is a leaf, and stands for all voxels below it.
struct Place {
  OcTreeNode* node;
  bool is_new;
};

/// The child, made where there is none.
Place child(OcTree& tree, const Place& at, unsigned i) {
  if (!at.is_new && !tree.nodeHasChildren(at.node)) tree.expandNode(at.node);
  if (tree.nodeChildExists(at.node, i)) return {tree.getNodeChild(at.node, i), false};
  return {tree.createNodeChild(at.node, i), true};
}

/// Makes a leaf of a node, whatever hangs below it.
void make_leaf(OcTree& tree, OcTreeNode* node, float log_odds) {
  if (tree.nodeHasChildren(node)) {
    for (unsigned i = 0; i < 8; ++i) {
      OcTreeNode* below = tree.nodeChildExists(node, i) ? tree.getNodeChild(node, i)
                                                        : tree.createNodeChild(node, i);
      make_leaf(tree, below, log_odds);
    }
    tree.pruneNode(node);
  }
  node->setLogOdds(log_odds);
}

/// Makes the tree below a place equal to a cube of a block.
void copy(OcTree& tree, const Place& at, const VoxelBlock& block, const Cube& cube) {
  if (holds_one_value(block, cube)) {
    return make_leaf(tree, at.node, block.log_odds[cube.first()]);
  }
  for (unsigned i = 0; i < 8; ++i) {
    const Cube part = cube.child(i);
    if (is_known_somewhere(block, part)) copy(tree, child(tree, at, i), block, part);
  }
  at.node->updateOccupancyChildren();
}

/// Makes the tree below a place equal to the changed blocks in it, which lie together on the
/// Z-curve; `level` counts from the leaves.
void copy(OcTree& tree, const Place& at, int level, Changes first, Changes last) {
  if (level == kBlockLevel) return copy(tree, at, *first->block, Cube{0, 0, 0, kBlockLevel});
  const int shift = 3 * (level - 1 - kBlockLevel);
  while (first != last) {
    const std::uint64_t place = first->place >> shift;
    const Changes next =
        std::find_if(first, last, [&](const Change& c) { return c.place >> shift != place; });
    copy(tree, child(tree, at, static_cast<unsigned>(place & 7)), level - 1, first, next);
    first = next;
  }
  if (!tree.pruneNode(at.node)) at.node->updateOccupancyChildren();
}

/// An octree cannot be given a root but by a voxel: one that the map holds, so that its branch is
/// written over at once.
void plant(OcTree& tree, const Change& change) {
  std::size_t i = 0;
  while (!change.block->is_known(i)) ++i;
  const auto part = [](int block, std::size_t voxel) {
    return static_cast<octomap::key_type>(8 * block + static_cast<int>(voxel));
  };
  const octomap::OcTreeKey key(part(change.key.x, i % 8), part(change.key.y, i / 8 % 8),
                               part(change.key.z, i / 64));
  tree.setNodeValue(key, change.block->log_odds[i], true);
}

std::vector<Change> changes_since(const OctoMapper& map, std::optional<OctoMapper::Revision> seen) {
  std::vector<Change> changes;
  const auto note = [&](BlockKey key, const VoxelBlock& block) {
    changes.push_back({place_of(key), key, &block});
  };
  if (seen) {
    map.blocks().for_each_changed_since(*seen, note);
  } else {
    map.blocks().for_each(note);
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.place < b.place; });
  return changes;
}

/// Brings the tree from what the map was at a revision to what it is.
void update(OcTree& tree, const OctoMapper& map, std::optional<OctoMapper::Revision> seen) {
  const std::vector<Change> changes = changes_since(map, seen);
  if (changes.empty()) return;
  if (tree.getRoot() == nullptr) plant(tree, changes.front());
  copy(tree, {tree.getRoot(), false}, kTreeDepth, changes.begin(), changes.end());
}

void configure(OcTree& tree, const OctoMapper::Options& options) {
  configure(tree, options.sensor_model);
  tree.setOccupancyThres(options.occupancy_threshold);
}

}  // namespace

OctreeMirror::OctreeMirror(const OctoMapper::Options& options) : tree_(options.resolution) {
  configure(tree_, options);
}

void OctreeMirror::follow(const OctoMapper& map, std::size_t generation) {
  if (seen_ && generation != generation_) {
    tree_.clear();
    seen_.reset();
  }
  update(tree_, map, seen_);
  seen_ = map.revision();
  generation_ = generation;
}

octomap::OcTree octree(const OctoMapper& map) {
  OcTree tree(map.options().resolution);
  configure(tree, map.options());
  update(tree, map, std::nullopt);
  return tree;
}

}  // namespace portolan
