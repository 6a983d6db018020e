// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <functional>
#include <string>

namespace portolan {

/// What a file of octomap says before its nodes.
struct OctreeHeader {
  bool is_binary = false;  ///< .bt: leaves are free or occupied; .ot: they have log-odds
  std::size_t nodes = 0;
  double resolution = 0.0;  ///< [m]
  std::size_t data = 0;     ///< where the nodes begin [byte]
};

/// Reads the header of a `.bt` or `.ot` file. Throws std::runtime_error that names the fault.
OctreeHeader read_octree_header(const std::string& file);

/// A leaf: a cube of 2^level voxels on a side, from this corner on.
struct OctreeLeaf {
  octomap::OcTreeKey corner;
  int level;
  float log_odds;
};

/// Calls visit(leaf) for each leaf of the file, and believes nothing in it: throws
/// std::runtime_error where it is cut off, too deep, longer than its nodes, holds another number
/// of nodes than it says or log-odds that are no numbers. Free and occupied leaves of a `.bt` file
/// get these log-odds.
void read_octree(const std::string& file, const OctreeHeader& header, float free_log_odds,
                 float occupied_log_odds, const std::function<void(const OctreeLeaf&)>& visit);

}  // namespace portolan
