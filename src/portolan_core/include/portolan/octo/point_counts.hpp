// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace portolan {

/// What became of the points that a 3D map was given: the answer to "why does it stay empty?".
struct PointCounts {
  std::uint64_t hits = 0;            ///< ended in an occupied voxel
  std::uint64_t beyond_range = 0;    ///< further than the maximum range: cleared the way up to it
  std::uint64_t ground = 0;          ///< found to be the ground: cleared the way to it
  std::uint64_t no_returns = 0;      ///< nothing came back: cleared the way up to the maximum range
  std::uint64_t too_near = 0;        ///< nearer than the minimum range: ignored
  std::uint64_t not_finite = 0;      ///< NaN or infinite: ignored
  std::uint64_t outside_octree = 0;  ///< further from the map's origin than 32768 voxels: ignored
  std::uint64_t silent = 0;          ///< readings that say nothing, and no returns that are ignored
};

}  // namespace portolan
