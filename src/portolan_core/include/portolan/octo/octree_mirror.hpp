// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <cstddef>
#include <optional>

#include "portolan/octo/octo_mapper.hpp"

namespace portolan {

/// A real octomap::OcTree that follows a map: pruned, with the same leaves, and brought up to date
/// at a cost that goes with what changed in the map, not with its size.
class OctreeMirror {
 public:
  explicit OctreeMirror(const OctoMapper::Options& options);

  /// Makes the tree equal to the map. `generation` tells one map from another that took its place
  /// (see `Remapper::generation`): then the tree is made anew.
  void follow(const OctoMapper& map, std::size_t generation);

  const octomap::OcTree& tree() const { return tree_; }

 private:
  octomap::OcTree tree_;
  std::size_t generation_ = 0;
  std::optional<OctoMapper::Revision> seen_;
};

/// The map as an octree, made from nothing.
octomap::OcTree octree(const OctoMapper& map);

}  // namespace portolan
